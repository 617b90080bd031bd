#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/distance_ranking.hpp"
#include "sylph_core/search/pibt.hpp"
#include "sylph_core/search/policy_ranking.hpp"
#include "sylph_core/search/policy_steps.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// How long a search is policy-guided before it is guided by distance alone.
struct PolicyPatience {
  /// Configurations in a row that are no nearer to the goals, in the sum over the agents, than the
  /// nearest one so far. The next nearer one brings the network back.
  long configurations = std::numeric_limits<long>::max();
  /// Steps from the same configuration.
  int steps = std::numeric_limits<int>::max();
  /// Configurations in all, times agents: each keeps what the network said in memory.
  long agent_steps = std::numeric_limits<long>::max();
};

/// Policy-guided PIBT: agents rank their moves by what the network says. Agents of equal priority
/// choose by SVO, the most selfish level first, and within a level by distance from the start to
/// the goal, farthest first; from a priority of 30 timesteps on by that distance alone.
class PolicyGenerator : public ConfigurationGenerator {
 public:
  /// @param problem, steps, rng  must outlive this object; `patience` counts for it alone
  PolicyGenerator(const SearchProblem& problem, PolicySteps& steps, const MoveSettings& settings,
                  const PolicyPatience& patience, Rng& rng);

  std::unique_ptr<JointSteps> enter(const Vertices& configuration, const Vertices* before,
                                    const Priorities& priorities) override;

 private:
  bool isWorthAsking(const Vertices& configuration);

  const SearchProblem* problem_;
  PolicySteps* steps_;
  MoveSettings settings_;
  PolicyPatience patience_;
  Rng* rng_;
  DistanceRanking distance_ranking_;
  Pibt pibt_;
  std::vector<double> start_distances_;
  long least_to_go_ = std::numeric_limits<long>::max();
  long since_nearer_ = 0;
};

}  // namespace sylph
