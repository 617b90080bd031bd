#include "sylph_ros/run_node.hpp"
#include "sylph_sim/sim_node.hpp"

int main(int argc, char** argv) {
  return sylph_ros::runNode<sylph_sim::SimNode>(argc, argv, "sim", sylph_sim::readOptions);
}
