#pragma once

#include <ctime>
#include <string>

#include "sylph_core/experiment/experiment.hpp"

namespace sylph_adg_central {

/// The folder of one run and what is copied into it.
class RunFolder {
 public:
  /// Makes the folder unless it exists and puts copies of the experiment and its map, and the seed,
  /// into it.
  /// @param is_ours  this run has used the folder before; any other run's is refused if it is of
  /// another experiment, map or seed or has no event log to go on from
  /// @throws std::runtime_error naming what cannot be made or written, or the folder refused
  RunFolder(std::string path, const sylph::Experiment& experiment, bool is_ours);

  /// @throws std::runtime_error that the folder holds another run
  [[noreturn]] void refuse(const std::string& why) const;

  /// Absolute.
  const std::string& path() const { return path_; }
  /// events.jsonl in it.
  std::string eventLog() const { return path_ + "/events.jsonl"; }
  /// result.yaml in it.
  std::string result() const { return path_ + "/result.yaml"; }
  /// plan.txt in it.
  std::string plan() const { return path_ + "/plan.txt"; }

 private:
  std::string path_;
};

/// ROS_HOME or ~/.ros, then `sylph/<stamp>_<experiment>`, stamp in local time.
/// @throws std::runtime_error if neither ROS_HOME nor HOME is set
std::string defaultRunFolder(const std::string& experiment, std::time_t now);

}  // namespace sylph_adg_central
