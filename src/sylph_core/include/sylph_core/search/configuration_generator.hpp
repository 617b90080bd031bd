#pragma once

#include <memory>
#include <vector>

#include "sylph_core/search/graph.hpp"

namespace sylph {

/// Per agent the timesteps since it was last on its goal, 0 while it is there: the priority by
/// which PIBT lets agents choose (Okumura et al. 2022, Alg. 1).
using Priorities = std::vector<int>;

/// The joint steps that a generator makes from one configuration.
class JointSteps {
 public:
  virtual ~JointSteps() = default;

  /// All agents, the one that chooses first at the front. LaCAM binds agents in the same order.
  virtual const std::vector<AgentId>& order() const = 0;

  /// One step of all agents that keeps to the motion model.
  /// @param to  in: kNoVertex, or the vertex that an agent is bound to reach; out: the step
  /// @return false if none was found. Where all agents are bound, must be true exactly if the step
  /// is legal: LaCAM's completeness rests on that.
  virtual bool generate(Vertices& to) = 0;
};

/// Where LaCAM's successor configurations come from.
class ConfigurationGenerator {
 public:
  virtual ~ConfigurationGenerator() = default;

  /// Comes to a configuration.
  /// @param configuration, priorities  must outlive the result
  /// @param before  the configuration one timestep earlier, nullptr where the search starts
  /// @return must not outlive this object
  virtual std::unique_ptr<JointSteps> enter(const Vertices& configuration, const Vertices* before,
                                            const Priorities& priorities) = 0;
};

}  // namespace sylph
