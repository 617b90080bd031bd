#include <ros/init.h>
#include <ros/names.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "sylph_ros/topics.hpp"
#include "sylph_ros/trigger_command.hpp"

/// Tells a robot of the fleet in the present namespace that its operator has looked: its pose is
/// right. Exit status: 0 the robot believes it, 1 with one line why not.
int main(int argc, char** argv) {
  const std::string command = "sylph_confirm_pose";
  ros::init(argc, argv, command, ros::init_options::AnonymousName);
  if (argc != 2) {
    std::cerr << "usage: " << command
              << " ROBOT   (the fleet is that of ROS_NAMESPACE or __ns:=)\n";
    return EXIT_FAILURE;
  }
  const std::string robot = argv[1];
  if (std::string why; !ros::names::validate(robot, why)) {
    std::cerr << command << ": " << robot << " is not a robot's name: " << why << "\n";
    return EXIT_FAILURE;
  }
  return sylph_ros::runTriggerCommand({command, robot + "/" + sylph_ros::kConfirmPoseService,
                                       "node of " + robot + " in this namespace",
                                       "the robot goes on holding"});
}
