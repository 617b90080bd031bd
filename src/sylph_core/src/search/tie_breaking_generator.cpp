#include "sylph_core/search/tie_breaking_generator.hpp"

#include <numeric>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/social/tie_breaking.hpp"

namespace sylph {

TieBreakingGenerator::TieBreakingGenerator(const SearchProblem& problem, const Grid& grid,
                                           PolicySteps& steps, const MoveSettings& settings,
                                           Rng& rng)
    : problem_(&problem), grid_(&grid), steps_(&steps), ranking_(problem, settings, rng) {}

std::vector<AgentId> TieBreakingGenerator::order(const Vertices& configuration,
                                                 const Vertices* before,
                                                 const std::vector<int>& waited) {
  step_ = &steps_->enter(configuration, before).step;
  waited_ = waited;
  std::vector<AgentId> order(configuration.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

bool TieBreakingGenerator::generate(const Vertices& from, const std::vector<AgentId>& order,
                                    Vertices& to) {
  ranking_.listenTo(step_->actions, waited_);
  ranking_.observe(from);
  const Vertices bound = to;
  std::vector<Action> wishes(from.size(), Action::Stay);
  for (const AgentId agent : order) {
    const VertexId target = bound[agent] != kNoVertex ? bound[agent] : choose(agent, from[agent]);
    wishes[agent] =
        *actionBetween(problem_->graph.cellAt(from[agent]), problem_->graph.cellAt(target));
  }
  const Configuration cells = problem_->graph.toCells(from);
  const TieBreaking broken =
      breakTies(*grid_, problem_->motion, cells, wishes, step_->social.svo_deg);
  bool is_bound_kept = true;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    to[agent] = problem_->graph.vertexAt(neighbor(cells[agent], broken.actions[agent]));
    is_bound_kept = is_bound_kept && (bound[agent] == kNoVertex || bound[agent] == to[agent]);
  }
  return is_bound_kept;
}

VertexId TieBreakingGenerator::choose(AgentId agent, VertexId at) {
  Moves moves;
  for (const VertexId target : problem_->graph.neighbors(at)) {
    moves.targets[moves.count++] = target;
  }
  moves.targets[moves.count++] = at;
  ranking_.rank(agent, at, moves);
  return moves.targets[0];
}

}  // namespace sylph
