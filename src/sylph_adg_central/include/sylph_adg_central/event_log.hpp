#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "sylph_core/execution/event_line.hpp"

namespace sylph_adg_central {

/// The log of a run: one JSON object a line, only ever appended to, each line on its way to the
/// disk before the call returns.
class EventLog {
 public:
  /// Opens the log, and makes it if it does not exist. What a crash left of a last line without end
  /// is cut off.
  /// @param names  of the robots, by index
  /// @throws std::runtime_error with file and line if the file cannot be read and written or a line
  /// is malformed
  EventLog(std::string path, std::vector<std::string> names);

  /// What was in the log when it was opened.
  const std::vector<sylph::StampedEvent>& past() const { return past_; }

  /// @throws std::runtime_error if it cannot be written
  void append(const sylph::StampedEvent& event);

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::vector<sylph::StampedEvent> past_;
  std::ofstream file_;
};

}  // namespace sylph_adg_central
