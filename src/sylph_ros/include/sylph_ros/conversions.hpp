#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <sylph_msgs/Cell.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/cell.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph_ros {

sylph_msgs::Cell toMessage(const sylph::Cell& cell);
std::vector<sylph_msgs::Cell> toMessage(const std::vector<sylph::Cell>& cells);
sylph::Cell fromMessage(const sylph_msgs::Cell& message);

/// AgentAction's constants have the values of sylph::Action.
std::uint8_t toMessage(sylph::Action action);
/// @return nothing if the number is no action
std::optional<sylph::Action> actionFromMessage(std::uint8_t action);

/// Height 0.
geometry_msgs::Point toMessage(const sylph::Point& point);

/// Rotation about z by `yaw_rad`.
geometry_msgs::Quaternion quaternionFromYaw(double yaw_rad);
/// Yaw of a rotation, in (-pi, pi] [rad].
double yawOf(const geometry_msgs::Quaternion& quaternion);

}  // namespace sylph_ros
