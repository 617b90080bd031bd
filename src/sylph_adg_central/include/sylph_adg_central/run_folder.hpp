#pragma once

#include <ctime>
#include <string>

#include "sylph_core/experiment/experiment.hpp"

namespace sylph_adg_central {

/// The folder of one run and what is copied into it.
class RunFolder {
 public:
  /// Makes the folder unless it exists and puts a copy of the experiment into it.
  /// @throws std::runtime_error naming what cannot be made or written
  RunFolder(std::string path, const sylph::Experiment& experiment);

  const std::string& path() const { return path_; }
  std::string eventLog() const { return path_ + "/events.jsonl"; }
  std::string result() const { return path_ + "/result.yaml"; }
  std::string plan() const { return path_ + "/plan.txt"; }

 private:
  std::string path_;
};

/// ROS_HOME or ~/.ros, then `sylph/<stamp>_<experiment>`, stamp in local time.
/// @throws std::runtime_error if neither ROS_HOME nor HOME is set
std::string defaultRunFolder(const std::string& experiment, std::time_t now);

}  // namespace sylph_adg_central
