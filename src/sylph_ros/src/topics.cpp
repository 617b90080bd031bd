#include "sylph_ros/topics.hpp"

#include <ros/names.h>

namespace sylph_ros {

std::string fleetName(const ros::NodeHandle& nh, const std::string& name) {
  return ros::names::append(ros::names::parentNamespace(nh.getNamespace()), name);
}

std::string robotTopic(const ros::NodeHandle& nh, const std::string& robot,
                       const std::string& topic) {
  return fleetName(nh, ros::names::append(robot, topic));
}

ros::NodeHandle suiteHandle(const ros::NodeHandle& robot_nh) {
  return {fleetName(robot_nh, kSuiteNamespace)};
}

}  // namespace sylph_ros
