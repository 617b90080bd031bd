#include "sylph_adg_central/separation_monitor_node.hpp"
#include "sylph_ros/run_node.hpp"

int main(int argc, char** argv) {
  return sylph_ros::runNode<sylph_adg_central::SeparationMonitorNode>(
      argc, argv, "sylph_separation_monitor", sylph_adg_central::readSeparationMonitorOptions);
}
