#include "sylph_mocap_bridge/mocap_bridge_node.hpp"
#include "sylph_ros/run_node.hpp"

int main(int argc, char** argv) {
  return sylph_ros::runNode<sylph_mocap_bridge::MocapBridgeNode>(
      argc, argv, "mocap_bridge", [](sylph_ros::ParameterReader& reader) {
        sylph_mocap_bridge::readOptions(reader, {"<robot>"});
      });
}
