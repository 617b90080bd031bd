#include "sylph_robot_node/other_node.hpp"
#include "sylph_robot_node/robot_node.hpp"
#include "sylph_ros/run_node.hpp"

int main(int argc, char** argv) {
  if (sylph_ros::printParameters(argc, argv, sylph_robot_node::readOptions)) {
    return EXIT_SUCCESS;
  }
  sylph_ros::initNode(argc, argv, "sylph_robot");
  sylph_robot_node::waitForOtherNode();
  return sylph_ros::spinNode<sylph_robot_node::RobotNode>();
}
