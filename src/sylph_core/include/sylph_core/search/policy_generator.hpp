#pragma once

#include <limits>
#include <unordered_map>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/distance_ranking.hpp"
#include "sylph_core/search/pibt.hpp"
#include "sylph_core/search/policy_ranking.hpp"
#include "sylph_core/search/policy_steps.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// How long a search goes by the network before it goes by distance.
struct PolicyPatience {
  /// Configurations in a row that are no nearer to the goals, in the sum over the agents, than the
  /// nearest one so far. The next nearer one brings the network back.
  long configurations = std::numeric_limits<long>::max();
  /// Steps from the same configuration.
  int steps = std::numeric_limits<int>::max();
  /// Configurations in all, times agents: each keeps what the network said in memory.
  long agent_steps = std::numeric_limits<long>::max();
};

/// PIBT whose agents want what the policy network says. Agents that waited equally long choose by
/// SVO, the most selfish level first, and within a level by distance from the start to the goal,
/// farthest first; where they have waited for 30 timesteps by that distance alone.
class PolicyGenerator : public ConfigurationGenerator {
 public:
  /// @param problem, steps, rng  must outlive this object
  PolicyGenerator(const SearchProblem& problem, PolicySteps& steps, const MoveSettings& settings,
                  const PolicyPatience& patience, Rng& rng);

  std::vector<AgentId> order(const Vertices& configuration, const Vertices* before,
                             const std::vector<int>& waited) override;
  bool generate(const Vertices& from, const std::vector<AgentId>& order, Vertices& to) override;

 private:
  struct Visit {
    std::vector<int> waited;
    int steps = 0;  // made from there
  };

  bool isWorthAsking(const Vertices& configuration);

  const SearchProblem* problem_;
  PolicySteps* steps_;
  PolicyPatience patience_;
  PolicyRanking policy_ranking_;
  DistanceRanking distance_ranking_;
  Pibt pibt_;
  std::vector<double> start_distances_;
  std::unordered_map<const PolicySteps::Entry*, Visit> visits_;
  long least_to_go_ = std::numeric_limits<long>::max();
  long since_nearer_ = 0;
};

}  // namespace sylph
