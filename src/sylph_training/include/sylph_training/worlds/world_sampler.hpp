#pragma once

#include "sylph_core/files/yaml_map.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/instance.hpp"

namespace sylph_training {

/// Bounds between which a quantity is drawn uniformly, both included.
struct Interval {
  double lowest;
  double highest;
};

/// How one family of maps is drawn.
struct FamilySettings {
  double weight;        ///< chance of the family in proportion to the others', >= 0
  Interval team_share;  ///< agents as a share of the free cells, above 0 and at most 1
};

/// What worlds are drawn from: the curriculum of training.
struct WorldSettings {
  Interval side{10, 40};                     ///< of the square map [cells]
  Interval usual_side{20, 32};               ///< where most maps are drawn from
  double usual_share = 0.6;                  ///< chance that the side is a usual one
  FamilySettings random{0.4, {0.02, 0.40}};  ///< cells blocked at random
  Interval density{0.0, 0.3};                ///< share of obstacles in random maps
  FamilySettings room{0.3, {0.02, 0.32}};    ///< rooms with doors
  Interval room_size{3, 5};                  ///< side of the rooms [cells]
  Interval door_share{0.6, 1.0};             ///< see RoomMapSpec
  FamilySettings maze{0.3, {0.02, 0.18}};    ///< corridors of one cell
  Interval opened_share{0.0, 0.2};           ///< see MazeMapSpec
  int most_agents = 320;                     ///< in any world, > 0
  sylph::MotionModel motion;                 ///< of the instances

  /// Reads what is given and keeps the rest as it is.
  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static WorldSettings read(const sylph::YamlMap& yaml);
};

/// A random world: a map of one of the families with a team of agents on it. The same settings and
/// generator state give the same world.
sylph::Instance sampleWorld(const WorldSettings& settings, sylph::Rng& rng);

}  // namespace sylph_training
