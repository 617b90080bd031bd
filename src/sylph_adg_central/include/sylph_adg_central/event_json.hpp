#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sylph_core/execution/execution_event.hpp"

namespace sylph_adg_central {

/// One event as an object: `stamp` (ROS time [s]), `event`, `plan_id`, and where they mean
/// something `robot` (name), `number`, `text`, `plan`.
/// @param names  of the robots, by index
nlohmann::json toJson(const sylph::ExecutionEvent& event, double stamp_s,
                      const std::vector<std::string>& names);

/// @throws std::runtime_error with what is wrong, also if the robot is not among `names`
sylph::ExecutionEvent eventFromJson(const nlohmann::json& json,
                                    const std::vector<std::string>& names);

}  // namespace sylph_adg_central
