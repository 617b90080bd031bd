#include "sylph_rviz/conversions.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sylph_ros/plan_messages.hpp"

namespace sylph_rviz {

Scene sceneOf(const sylph::Experiment& experiment) {
  Scene scene;
  scene.map = MapExtent{experiment.grid.rows(), experiment.grid.cols(), experiment.cell_size_m,
                        experiment.corner};
  for (const sylph::RobotSpec& spec : experiment.robots) {
    RobotView robot;
    robot.name = spec.name;
    robot.length_m = spec.length_m;
    robot.width_m = spec.width_m;
    robot.goal = spec.goal;
    scene.robots.push_back(std::move(robot));
  }
  return scene;
}

std::optional<MapExtent> extentOf(const nav_msgs::OccupancyGrid& message) {
  if (message.info.width == 0 || message.info.height == 0 || !(message.info.resolution > 0.0F)) {
    return std::nullopt;
  }
  return MapExtent{static_cast<int>(message.info.height),
                   static_cast<int>(message.info.width),
                   static_cast<double>(message.info.resolution),
                   {message.info.origin.position.x, message.info.origin.position.y}};
}

std::optional<sylph::MissionPlan> planOf(const sylph_msgs::JointActions& message) {
  if (message.plan_id == 0) {
    return std::nullopt;
  }
  try {
    return sylph_ros::fromMessage(message);
  } catch (const std::invalid_argument& error) {
    ROS_WARN_THROTTLE(1.0, "dropped plan %u: %s", message.plan_id, error.what());
    return std::nullopt;
  }
}

geometry_msgs::PolygonStamped footprintOf(const RobotView& robot) {
  const auto x = static_cast<float>(0.5 * robot.length_m);
  const auto y = static_cast<float>(0.5 * robot.width_m);
  geometry_msgs::PolygonStamped message;
  message.header.frame_id = robot.name;
  message.polygon.points.resize(4);
  message.polygon.points[0].x = message.polygon.points[3].x = -x;
  message.polygon.points[1].x = message.polygon.points[2].x = x;
  message.polygon.points[0].y = message.polygon.points[1].y = -y;
  message.polygon.points[2].y = message.polygon.points[3].y = y;
  return message;
}

void setFootprint(RobotView& robot, const geometry_msgs::PolygonStamped& footprint) {
  float x = 0.0F;
  float y = 0.0F;
  for (const geometry_msgs::Point32& corner : footprint.polygon.points) {
    x = std::max(x, std::abs(corner.x));
    y = std::max(y, std::abs(corner.y));
  }
  if (x > 0.0F && y > 0.0F && std::isfinite(x) && std::isfinite(y)) {
    robot.length_m = 2.0 * static_cast<double>(x);
    robot.width_m = 2.0 * static_cast<double>(y);
  }
}

}  // namespace sylph_rviz
