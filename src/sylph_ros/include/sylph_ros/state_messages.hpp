#pragma once

#include <sylph_msgs/AdgState.h>

#include <optional>

#include "sylph_core/execution/adg_state.hpp"

/// The state of execution on the wire.
namespace sylph_ros {

/// Stamp left to the caller.
sylph_msgs::AdgState toMessage(const sylph::AdgState& state);

/// @return nothing if phase, mode, or a robot's condition, state, action or a count is none
std::optional<sylph::AdgState> fromMessage(const sylph_msgs::AdgState& message);

/// Nothing if the number is no mode.
std::optional<sylph::ExecutionMode> modeFromMessage(const sylph_msgs::AdgState& message);

}  // namespace sylph_ros
