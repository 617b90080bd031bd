#include "sylph_core/planners/social_states.hpp"

#include "sylph_core/social/partners.hpp"

namespace sylph {

std::vector<SocialState> socialStatesOf(const SearchProblem& problem, const Grid& grid,
                                        const Plan& plan) {
  const auto distance = [&problem](AgentId agent, const Cell& cell) {
    return problem.distances.get(agent, problem.graph.vertexAt(cell));
  };
  return partnersAlongPlan(grid, distance, plan);
}

}  // namespace sylph
