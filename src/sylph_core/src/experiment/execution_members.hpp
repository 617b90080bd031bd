#pragma once

#include <array>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/files/range.hpp"

namespace sylph {

/// A number of ExecutionSpec as an experiment file has it.
struct ExecutionMember {
  const char* key;
  double ExecutionSpec::*value;
  Range (*range)();
};

/// All of them, for who reads and who writes.
inline constexpr std::array<ExecutionMember, 9> kExecutionMembers = {{
    {"speed_limit_mps", &ExecutionSpec::speed_limit_mps, Range::positive},
    {"acceleration_limit_mps2", &ExecutionSpec::acceleration_limit_mps2, Range::positive},
    {"turn_rate_limit_radps", &ExecutionSpec::turn_rate_limit_radps, Range::positive},
    {"position_tolerance_m", &ExecutionSpec::position_tolerance_m, Range::positive},
    {"heading_tolerance_rad", &ExecutionSpec::heading_tolerance_rad, Range::positive},
    {"tracking_error_m", &ExecutionSpec::tracking_error_m, Range::positive},
    {"pose_timeout_s", &ExecutionSpec::pose_timeout_s, Range::positive},
    {"base_timeout_s", &ExecutionSpec::base_timeout_s, Range::positive},
    {"command_latency_s", &ExecutionSpec::command_latency_s, [] { return Range::atLeast(0.0); }},
}};

}  // namespace sylph
