#pragma once

#include <array>
#include <string>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Side of the square that an agent sees, itself in the centre [cells].
constexpr int kFieldOfView = 9;
constexpr int kViewCells = kFieldOfView * kFieldOfView;

/// What each cell of the field of view tells. The first nine are those of the paper (there with the
/// four directions inverted and only in the central 5 x 5); the others are what measured better.
enum class Channel {
  Obstacle,       ///< obstacle or outside the map
  Agent,          ///< an agent, oneself included
  OwnGoal,        ///< one's own goal
  ProjectedGoal,  ///< goals of the agents in view, clamped to the border
  LessProsocial,  ///< an agent whose SVO is lower than one's own
  NearerNorth,    ///< from here a step north comes closer to one's own goal
  NearerEast,
  NearerSouth,
  NearerWest,
  OtherGoal,    ///< the goal of any other agent
  FartherToGo,  ///< an agent that has farther to its goal than oneself
  WishesNorth,  ///< an other agent here that comes closer to its goal by going north
  WishesEast,
  WishesSouth,
  WishesWest,
  AtGoal,     ///< an other agent that is on its goal
  CameNorth,  ///< an other agent whose last move was north
  CameEast,
  CameSouth,
  CameWest,
  CostToGo,  ///< how much farther from one's own goal than oneself, in -1 ... 1; obstacles 1
};
constexpr int kChannelCount = 21;

/// Names of the channels in order: part of the contract with the weights.
const std::array<std::string, kChannelCount>& channelNames();

/// Entries of the vector that goes with the field of view: unit direction to the goal (x right, y
/// up), straight distance and way to go (both / 64, at most 1), whether on the goal.
constexpr int kVectorSize = 5;

constexpr int kObservationSize = kViewCells * kChannelCount;

/// Where the agents are and how they came there.
struct AgentStates {
  Configuration cells;
  std::vector<Action> last_moves;  ///< the action that led here; Stay at the start
  std::vector<float> svo_deg;      ///< mean SVO [deg]
};

/// Turns the state of all agents into what the network sees.
class ObservationEncoder {
 public:
  /// @param distances  per agent the distances to its goal; must outlive the encoder
  ObservationEncoder(const Grid& grid, const std::vector<DistanceField>& distances);

  /// @param states  one entry per agent
  void setStates(const AgentStates& states);

  /// The view of one agent, row by row from the north west, the channels of a cell side by side.
  /// @param view    out: kObservationSize floats
  /// @param vector  out: kVectorSize floats
  void encode(AgentId agent, float* view, float* vector) const;

 private:
  int indexOf(const Cell& cell) const {
    return (cell.row + kMargin) * stride_ + cell.col + kMargin;
  }
  void addOwnWay(AgentId agent, float* view) const;
  void addOthers(AgentId agent, float* view) const;
  void addGoals(AgentId agent, float* view) const;
  void addVector(AgentId agent, float* vector) const;

  static constexpr int kMargin = kFieldOfView / 2;  // of obstacles round the map: no view leaves it

  int stride_;
  const std::vector<DistanceField>& distances_;
  std::vector<char> is_obstacle_;    // with margin
  std::vector<AgentId> occupant_;    // with margin, -1: nobody
  std::vector<AgentId> goal_owner_;  // with margin, -1: nobody's goal
  AgentStates states_;
  std::vector<std::array<float, kChannelCount>>
      seen_;  // per agent, channels that do not depend on who looks
  std::vector<int> to_go_;
};

}  // namespace sylph
