#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sylph_natnet/types.hpp"

namespace sylph_mocap_bridge {

/// Which rigid body is which robot, by the names that the server tells. A name or an id that
/// appears twice is nobody: it could be the wrong robot.
class BodyNames {
 public:
  /// @param rigid_bodies  name of the rigid body of each robot
  explicit BodyNames(std::vector<std::string> rigid_bodies);

  /// Takes what the server tells anew; forgets what it told before.
  void update(const sylph_natnet::ModelDefinitions& definitions);

  /// @return index of the robot whose rigid body has this id; nothing if it is none of ours
  std::optional<std::size_t> robotOf(std::int32_t body_id) const;

  /// Names of robots that the server does not have.
  const std::vector<std::string>& missing() const { return missing_; }
  /// Names that the server has more than once, or under an id that another name has too.
  const std::vector<std::string>& ambiguous() const { return ambiguous_; }
  /// All names that the server told.
  const std::vector<std::string>& offered() const { return offered_; }

 private:
  std::vector<std::string> rigid_bodies_;
  std::unordered_map<std::int32_t, std::size_t> robot_of_id_;
  std::vector<std::string> missing_;
  std::vector<std::string> ambiguous_;
  std::vector<std::string> offered_;
};

}  // namespace sylph_mocap_bridge
