#pragma once

#include <vector>

#include "sylph_core/search/graph.hpp"

namespace sylph {

/// Where LaCAM's successor configurations come from.
class ConfigurationGenerator {
 public:
  virtual ~ConfigurationGenerator() = default;

  /// All agents in the order in which they choose in a configuration; LaCAM binds agents in the
  /// same order. Called once when a search comes to a configuration, before steps from there.
  /// @param before  the configuration one timestep earlier, nullptr where the search starts
  /// @param waited  per agent: timesteps since it was last on its goal, 0 where it is on it
  virtual std::vector<AgentId> order(const Vertices& configuration, const Vertices* before,
                                     const std::vector<int>& waited) = 0;

  /// One step of all agents that keeps to the motion model.
  /// @param to  in: kNoVertex, or the vertex that an agent is bound to reach; out: the step
  /// @return false if none was found. Where all agents are bound, must be true exactly if the step
  /// is legal: LaCAM's completeness rests on that.
  virtual bool generate(const Vertices& from, const std::vector<AgentId>& order, Vertices& to) = 0;
};

}  // namespace sylph
