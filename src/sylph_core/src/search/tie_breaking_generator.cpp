#include "sylph_core/search/tie_breaking_generator.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/social/tie_breaking.hpp"

namespace sylph {
namespace {

class TieBreakingSteps : public JointSteps {
 public:
  TieBreakingSteps(const SearchProblem& problem, const Grid& grid, PolicyRanking ranking,
                   std::vector<float> yielding, const Vertices& configuration)
      : problem_(&problem),
        grid_(&grid),
        ranking_(std::move(ranking)),
        yielding_(std::move(yielding)),
        configuration_(&configuration),
        occupied_now_(static_cast<std::size_t>(problem.graph.size()), kNoAgent),
        order_(configuration.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    for (const AgentId agent : order_) {
      occupied_now_[configuration[agent]] = agent;
    }
  }

  /// By index: it is of no consequence, since all agents choose for themselves.
  const std::vector<AgentId>& order() const override { return order_; }

  bool generate(Vertices& to) override {
    const Configuration cells = problem_->graph.toCells(*configuration_);
    std::vector<Action> desired;
    for (const AgentId agent : order_) {
      const VertexId target = to[agent] != kNoVertex ? to[agent] : choose(agent);
      desired.push_back(*actionBetween(cells[agent], problem_->graph.cellAt(target)));
    }
    const TieBreaking broken = breakTies(*grid_, problem_->motion, cells, desired, yielding_);
    bool is_bound_kept = true;
    for (const AgentId agent : order_) {
      const VertexId bound = to[agent];
      to[agent] = problem_->graph.vertexAt(neighbor(cells[agent], broken.actions[agent]));
      is_bound_kept = is_bound_kept && (bound == kNoVertex || bound == to[agent]);
    }
    return is_bound_kept;
  }

 private:
  VertexId choose(AgentId agent) {
    const VertexId at = (*configuration_)[agent];
    Moves moves = movesFrom(problem_->graph, at);
    ranking_.rank(agent, at, occupied_now_, moves);
    return moves.targets[0];
  }

  const SearchProblem* problem_;
  const Grid* grid_;
  PolicyRanking ranking_;
  std::vector<float> yielding_;  // per agent: the higher, the sooner it yields
  const Vertices* configuration_;
  Occupants occupied_now_;
  std::vector<AgentId> order_;
};

}  // namespace

TieBreakingGenerator::TieBreakingGenerator(const SearchProblem& problem, const Grid& grid,
                                           PolicySteps& steps, const MoveSettings& settings,
                                           bool by_svo, Rng& rng)
    : problem_(&problem),
      grid_(&grid),
      steps_(&steps),
      settings_(settings),
      by_svo_(by_svo),
      rng_(&rng) {}

std::unique_ptr<JointSteps> TieBreakingGenerator::enter(const Vertices& configuration,
                                                        const Vertices* before,
                                                        const Priorities& priorities) {
  const PolicyStep& step = steps_->enter(configuration, before, StepUse::Social).step;
  std::vector<float> yielding = step.social.svo_deg;
  if (!by_svo_) {
    for (float& order : yielding) {
      order = static_cast<float>(drawFraction(*rng_));
    }
  }
  return std::make_unique<TieBreakingSteps>(
      *problem_, *grid_, PolicyRanking(*problem_, settings_, step.actions, priorities, *rng_),
      std::move(yielding), configuration);
}

}  // namespace sylph
