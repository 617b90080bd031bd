#include "sylph_planner_node/planner_node.hpp"
#include "sylph_ros/run_node.hpp"

int main(int argc, char** argv) {
  return sylph_ros::runNode<sylph_planner_node::PlannerNode>(argc, argv, "sylph_planner",
                                                             sylph_planner_node::readOptions);
}
