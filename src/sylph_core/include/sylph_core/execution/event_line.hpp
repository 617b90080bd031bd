#pragma once

#include <string>
#include <vector>

#include "sylph_core/execution/execution_event.hpp"

namespace sylph {

/// An event and when it happened.
struct StampedEvent {
  double stamp_s = 0.0;  ///< ROS time [s]
  ExecutionEvent event;
};

/// A line of the event log, without its end: a JSON object with `stamp`, `event`, `plan_id`, and
/// what it tells: `robot` (name), `sequence` or `count` of tasks, the word for a `condition`,
/// `mode` or `phase`, `reason`, `plan`.
/// @param names  of the robots, by index
std::string toLine(const StampedEvent& entry, const std::vector<std::string>& names);

/// @throws std::runtime_error with what is wrong, also if the robot is not among `names` or the
/// event was written by a version of the suite before 0.1.0
StampedEvent eventFromLine(const std::string& line, const std::vector<std::string>& names);

}  // namespace sylph
