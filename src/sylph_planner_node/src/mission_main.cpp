#include <ros/ros.h>

#include <cstdlib>
#include <exception>

#include "sylph_planner_node/mission_client.hpp"
#include "sylph_ros/run_node.hpp"

int main(int argc, char** argv) {
  if (sylph_ros::printParameters(argc, argv, sylph_planner_node::readClientOptions)) {
    return EXIT_SUCCESS;
  }
  sylph_ros::initNode(argc, argv, "sylph_mission");
  try {
    sylph_planner_node::MissionClient client(ros::NodeHandle(), ros::NodeHandle("~"));
    ros::AsyncSpinner spinner(1);
    spinner.start();
    const bool has_succeeded = client.run();
    if (!client.exitWhenDone()) {
      ros::waitForShutdown();
    }
    return has_succeeded ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return EXIT_FAILURE;
  }
}
