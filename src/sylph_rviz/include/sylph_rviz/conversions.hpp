#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sylph_msgs/JointActions.h>

#include <optional>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_rviz/scene.hpp"

namespace sylph_rviz {

/// Robots and map of an experiment, before anything has been measured.
Scene sceneOf(const sylph::Experiment& experiment);

/// @return nothing if the map is empty or its resolution not positive
std::optional<MapExtent> extentOf(const nav_msgs::OccupancyGrid& message);

/// @return nothing if the message withdraws a plan, or holds none that is one, which is logged
std::optional<sylph::MissionPlan> planOf(const sylph_msgs::JointActions& message);

/// The rectangle of a robot's footprint in its own frame, stamp 0.
geometry_msgs::PolygonStamped footprintOf(const RobotView& robot);
/// Takes length and width from a footprint; one without extent changes nothing.
void setFootprint(RobotView& robot, const geometry_msgs::PolygonStamped& footprint);

}  // namespace sylph_rviz
