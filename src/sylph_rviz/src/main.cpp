#include "sylph_ros/run_node.hpp"
#include "sylph_rviz/markers_node.hpp"

int main(int argc, char** argv) {
  return sylph_ros::runNode<sylph_rviz::MarkersNode>(argc, argv, "sylph_markers",
                                                     sylph_rviz::readOptions);
}
