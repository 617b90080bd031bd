#include "sylph_mocap_bridge/body_names.hpp"

#include <utility>

namespace sylph_mocap_bridge {

BodyNames::BodyNames(std::vector<std::string> rigid_bodies)
    : rigid_bodies_(std::move(rigid_bodies)), missing_(rigid_bodies_) {}

void BodyNames::update(const sylph_natnet::ModelDefinitions& definitions) {
  robot_of_id_.clear();
  missing_.clear();
  ambiguous_.clear();
  offered_.clear();
  std::unordered_map<std::string, int> names;
  std::unordered_map<std::int32_t, int> ids;
  for (const sylph_natnet::RigidBodyDefinition& body : definitions.rigid_bodies) {
    offered_.push_back(body.name);
    ++names[body.name];
    ++ids[body.id];
  }
  for (std::size_t robot = 0; robot < rigid_bodies_.size(); ++robot) {
    const std::string& name = rigid_bodies_[robot];
    if (names.count(name) == 0) {
      missing_.push_back(name);
      continue;
    }
    for (const sylph_natnet::RigidBodyDefinition& body : definitions.rigid_bodies) {
      if (body.name != name) {
        continue;
      }
      if (names[name] > 1 || ids[body.id] > 1) {
        ambiguous_.push_back(name);
        break;
      }
      robot_of_id_[body.id] = robot;
    }
  }
}

std::optional<std::size_t> BodyNames::robotOf(std::int32_t body_id) const {
  const auto found = robot_of_id_.find(body_id);
  if (found == robot_of_id_.end()) {
    return std::nullopt;
  }
  return found->second;
}

}  // namespace sylph_mocap_bridge
