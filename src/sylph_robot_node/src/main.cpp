#include "sylph_robot_node/robot_node.hpp"
#include "sylph_ros/run_node.hpp"

int main(int argc, char** argv) {
  return sylph_ros::runNode<sylph_robot_node::RobotNode>(argc, argv, "sylph_robot");
}
