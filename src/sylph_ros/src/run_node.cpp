#include "sylph_ros/run_node.hpp"

#include <ros/names.h>

#include <cstdlib>

namespace sylph_ros {
namespace {

/// Arguments of the form `name:=value`, as ros::init() reads them.
ros::M_string remappingsOf(int argc, char** argv) {
  ros::M_string remappings;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t sign = argument.find(":=");
    if (sign != std::string::npos) {
      remappings[argument.substr(0, sign)] = argument.substr(sign + 2);
    }
  }
  return remappings;
}

/// The node's namespace as ros::init() will find it.
std::string namespaceOf(const ros::M_string& remappings) {
  std::string name_space;
  const auto given = remappings.find("__ns");
  if (given != remappings.end()) {
    name_space = given->second;
  } else if (const char* environment = std::getenv("ROS_NAMESPACE")) {
    name_space = environment;
  }
  return ros::names::clean("/" + name_space);
}

}  // namespace

void initNode(int argc, char** argv, const std::string& name) {
  ros::M_string remappings = remappingsOf(argc, argv);
  const std::string fleet = ros::names::parentNamespace(namespaceOf(remappings));
  if (fleet != "/") {
    for (const std::string global : {"/clock", "/use_sim_time", "/tf", "/tf_static"}) {
      remappings.emplace(global, fleet + global);
    }
  }
  ros::init(remappings, name);
}

}  // namespace sylph_ros
