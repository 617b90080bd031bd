#pragma once

#include <array>
#include <vector>

#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/policy/occupancy_map.hpp"

namespace sylph {

/// Who has to make way for whom in one configuration, by the rules of PIBT: what a policy has to
/// know to do as PIBT does where agents meet.
class RightOfWay {
 public:
  /// Bits in the order of the moves North, East, South, West.
  using Directions = std::array<bool, 4>;

  /// @param map, distances  must outlive this object; distances per agent to its goal
  RightOfWay(const OccupancyMap& map, const std::vector<DistanceField>& distances);

  /// @param cells    where the agents are; the map has been told of them
  /// @param svo_deg  per agent; the lower, the earlier an agent chooses its move [deg]
  void setStates(const Configuration& cells, const std::vector<float>& svo_deg);

  /// Directions of the moves that come closer to the agent's goal.
  const Directions& desired(AgentId agent) const { return desired_[index(agent)]; }
  /// Directions of the agents that it wants past and has to back out with to a junction.
  const Directions& swaps(AgentId agent) const { return swaps_[index(agent)]; }
  /// Directions of the agents that would have to swap with it once it had moved as it desires.
  const Directions& clears(AgentId agent) const { return clears_[index(agent)]; }
  /// The lowest SVO of those that push the agent off its cell, by way of any number of others, or
  /// its own if that is lower: PIBT's inherited priority [deg]. A push goes where an agent desires
  /// to; an agent that can only go back to who pushes it pushes all round it unless a cell is free.
  float inheritedSvoDeg(AgentId agent) const { return inherited_deg_[index(agent)]; }

 private:
  struct Push;

  static std::size_t index(AgentId agent) { return static_cast<std::size_t>(agent); }
  int toGo(AgentId agent, int at) const { return (*distances_)[index(agent)].at(map_->cellAt(at)); }
  int waysOn(int at, int back, int& onward) const;
  bool haveToSwap(AgentId pusher, AgentId puller, int from, int to) const;
  void findSwaps(AgentId agent);
  void inherit(const std::vector<float>& svo_deg);
  Directions onwardOf(const Push& push) const;

  const OccupancyMap* map_;
  const std::vector<DistanceField>* distances_;
  std::vector<int> at_;  // per agent: index on the map
  std::vector<Directions> desired_, swaps_, clears_;
  std::vector<float> inherited_deg_;
};

}  // namespace sylph
