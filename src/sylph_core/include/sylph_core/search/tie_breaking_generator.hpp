#pragma once

#include <vector>

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/policy_ranking.hpp"
#include "sylph_core/search/policy_steps.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// The paper's joint step: every agent chooses for itself, then SVO-based tie-breaking takes out
/// the conflicts. Moves into obstacles are not among those that an agent chooses from.
/// He et al. 2024 (arXiv:2408.03063), Alg. 3, see breakTies().
class TieBreakingGenerator : public ConfigurationGenerator {
 public:
  /// @param problem, grid, steps, rng  must outlive this object
  TieBreakingGenerator(const SearchProblem& problem, const Grid& grid, PolicySteps& steps,
                       const MoveSettings& settings, Rng& rng);

  /// By index: the order is of no consequence.
  std::vector<AgentId> order(const Vertices& configuration, const Vertices* before,
                             const std::vector<int>& waited) override;
  /// From the configuration that order() was last asked about.
  bool generate(const Vertices& from, const std::vector<AgentId>& order, Vertices& to) override;

 private:
  VertexId choose(AgentId agent, VertexId at);

  const SearchProblem* problem_;
  const Grid* grid_;
  PolicySteps* steps_;
  PolicyRanking ranking_;
  const PolicyStep* step_ = nullptr;
  std::vector<int> waited_;
};

}  // namespace sylph
