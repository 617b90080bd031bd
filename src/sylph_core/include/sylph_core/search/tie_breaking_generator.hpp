#pragma once

#include <memory>

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
  /// @param by_svo  whether the more prosocial yields; otherwise who yields is drawn
  TieBreakingGenerator(const SearchProblem& problem, const Grid& grid, PolicySteps& steps,
                       const MoveSettings& settings, bool by_svo, Rng& rng);

  std::unique_ptr<JointSteps> enter(const Vertices& configuration, const Vertices* before,
                                    const Priorities& priorities) override;

 private:
  const SearchProblem* problem_;
  const Grid* grid_;
  PolicySteps* steps_;
  MoveSettings settings_;
  bool by_svo_;
  Rng* rng_;
};

}  // namespace sylph
