#include <ros/init.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "sylph_ros/topics.hpp"
#include "sylph_ros/trigger_command.hpp"

/// Asks the central node of the fleet in the present namespace for a mode, SYLPH_MODE: pause, stop
/// or resume. Exit status: 0 it is done, 1 with one line why not.
int main(int argc, char** argv) {
  const std::string mode = SYLPH_MODE;
  const std::string command = "sylph_" + mode;
  ros::init(argc, argv, command, ros::init_options::AnonymousName);
  if (argc != 1) {
    std::cerr << command << ": takes no arguments; the fleet is that of ROS_NAMESPACE or __ns:=\n";
    return EXIT_FAILURE;
  }
  return sylph_ros::runTriggerCommand(
      {command, std::string(sylph_ros::kSuiteNamespace) + "/" + mode,
       "central node in this namespace", "cut the robots' power if they move"});
}
