#pragma once

#include <array>
#include <string>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/policy/occupancy_map.hpp"
#include "sylph_core/policy/right_of_way.hpp"

namespace sylph {

/// Side of the square that an agent sees, itself in the centre [cells].
constexpr int kFieldOfView = 9;
constexpr int kViewCells = kFieldOfView * kFieldOfView;

/// What each cell of the field of view tells, see observationEntries(). The first nine are those of
/// the paper (there with the four directions inverted and only in the central 5 x 5); the others
/// are what measured better. Groups of four are in the order of the moves North to West. All but
/// the last three are 0 or 1.
enum class Channel {
  Obstacle,
  Agent,
  OwnGoal,
  ProjectedGoal,
  LessProsocial,
  NearerNorth,
  NearerEast,
  NearerSouth,
  NearerWest,
  OtherGoal,
  FartherToGo,
  DesiredNorth,
  DesiredEast,
  DesiredSouth,
  DesiredWest,
  AtGoal,
  CameNorth,
  CameEast,
  CameSouth,
  CameWest,
  SwapNorth,
  SwapEast,
  SwapSouth,
  SwapWest,
  ClearNorth,
  ClearEast,
  ClearSouth,
  ClearWest,
  Pressed,
  CostToGo,
  SvoGap,
  InheritedGap,
};
constexpr int kChannelCount = 32;
constexpr int kBinaryChannelCount = kChannelCount - 3;  ///< all but the last three

/// Entries of the vector that goes with the field of view, see observationEntries().
enum class VectorEntry {
  GoalRight,
  GoalUp,
  StraightDistance,
  WayToGo,
  OnGoal,
  Priority,
  TieBreak,
};
constexpr int kVectorSize = 7;

constexpr int kObservationSize =
    kViewCells * kChannelCount;  ///< numbers of one agent's field of view

/// One number that the network sees.
struct ObservationEntry {
  std::string name;     ///< in the metadata of weights, unique
  std::string meaning;  ///< for docs/observation.md
  double lowest;        ///< that the number can be
  double highest;       ///< that the number can be

  std::string toText() const;  ///< in one line
};

/// Channels in order, then the entries of the vector: the contract with the weights, in whose
/// metadata it stands.
const std::vector<ObservationEntry>& observationEntries();

/// The state of all agents that a policy acts in.
struct AgentStates {
  Configuration cells;             ///< where each agent is
  std::vector<Action> last_moves;  ///< the action that led here; Stay at the start
  std::vector<float> svo_deg;      ///< mean SVO [deg]
  std::vector<int> priorities;     ///< as in PIBT: timesteps since the agent was last on its goal
  std::vector<float> tie_breaks;   ///< 0 ... 1, the agent's own for good: no two are alike
};

/// Turns the state of all agents into what the network sees.
class ObservationEncoder {
 public:
  /// @param distances  per agent, to its goal; must outlive this object
  ObservationEncoder(const Grid& grid, const std::vector<DistanceField>& distances);

  /// Sets the configuration that encode() looks at.
  /// @throws std::invalid_argument unless there is one entry per agent in each member
  void setStates(const AgentStates& states);

  /// Observation of one agent.
  /// @param view    out: kObservationSize entries, the 9 x 9 view row by row, north-west first,
  ///                the channels of a cell side by side
  /// @param vector  out: kVectorSize entries
  void encode(AgentId agent, float* view, float* vector) const;

 private:
  void see(AgentId agent);
  void addOwnWay(AgentId agent, float* view) const;
  void addAgents(AgentId agent, float* view) const;
  void addSelf(AgentId agent, float* features) const;
  void addOther(AgentId agent, AgentId other, float* features) const;
  void addGoals(AgentId agent, float* view) const;
  void addVector(AgentId agent, float* vector) const;

  const std::vector<DistanceField>& distances_;
  OccupancyMap map_;
  RightOfWay right_of_way_;
  std::vector<AgentId> goal_owner_;  // per index of the map, -1: nobody
  AgentStates states_;
  std::vector<int> to_go_;  // per agent [cells]
  // Per agent: the channels that all who see it share.
  std::vector<std::array<float, kChannelCount>> seen_;
};

}  // namespace sylph
