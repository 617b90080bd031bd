#include "sylph_adg_central/central_node.hpp"
#include "sylph_ros/run_node.hpp"

int main(int argc, char** argv) {
  return sylph_ros::runNode<sylph_adg_central::CentralNode>(argc, argv, "sylph_adg_central",
                                                            sylph_adg_central::readCentralOptions);
}
