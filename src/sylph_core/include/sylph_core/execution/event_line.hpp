#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sylph_core/execution/execution_event.hpp"

namespace sylph_adg_central {

/// One event as an object: `stamp` (ROS time [s]), `event`, `plan_id`, and what it tells:
/// `robot` (name), `sequence` or `count` of tasks, the word for a `condition`, `mode` or `phase`,
/// `reason`, `plan`.
/// @param names  of the robots, by index
nlohmann::json toJson(const sylph::ExecutionEvent& event, double stamp_s,
                      const std::vector<std::string>& names);

/// @throws std::runtime_error with what is wrong, also if the robot is not among `names` or the
/// event was written by a version of the suite before 0.1.0
sylph::ExecutionEvent eventFromJson(const nlohmann::json& json,
                                    const std::vector<std::string>& names);

}  // namespace sylph_adg_central
