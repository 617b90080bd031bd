#include "sylph_training/imitation/reactive_teacher.hpp"

#include <algorithm>
#include <numeric>

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::AgentId;

// A move's key, the least of which is taken first: the distance in these units, then taste.
constexpr double kPerCell = 20.0;
constexpr double kOccupied = 0.6;
constexpr double kStraight = 1.2;
constexpr double kPerLogit = 0.5;
constexpr double kMostLogits = 8.0;  // so that taste never outweighs a cell

}  // namespace

ReactiveTeacher::Ranking::Ranking(const sylph::SearchProblem& problem, sylph::Rng& rng)
    : problem_(&problem), rng_(&rng) {}

void ReactiveTeacher::Ranking::prepare(const TeamState& team, const sylph::AgentRows* logits) {
  logits_ = logits;
  straight_.assign(team.states().cells.size(), sylph::kNoVertex);
  for (std::size_t agent = 0; agent < straight_.size(); ++agent) {
    const Action last = team.states().last_moves[agent];
    if (last != Action::Stay && team.isValid(static_cast<AgentId>(agent), last)) {
      straight_[agent] = problem_->graph.vertexAt(neighbor(team.states().cells[agent], last));
    }
  }
}

void ReactiveTeacher::Ranking::rank(AgentId agent, sylph::VertexId at,
                                    const sylph::Occupants& occupied_now, sylph::Moves& moves) {
  const sylph::Cell& cell = problem_->graph.cellAt(at);
  sortMoves(moves, [&](sylph::VertexId target) {
    double key = kPerCell * problem_->distances.get(agent, target) + sylph::drawFraction(*rng_);
    key += target != at && occupied_now[target] != sylph::kNoAgent ? kOccupied : 0.0;
    // Straight on rather than in zigzag, so that the policy has one answer to learn and not two.
    key -= target == straight_[static_cast<std::size_t>(agent)] ? kStraight : 0.0;
    if (logits_ != nullptr) {
      const Action action = *actionBetween(cell, problem_->graph.cellAt(target));
      const double logit = (*logits_)(agent, static_cast<Eigen::Index>(action));
      key -= kPerLogit * std::clamp(logit - static_cast<double>(logits_->row(agent).maxCoeff()),
                                    -kMostLogits, 0.0);
    }
    return key;
  });
}

ReactiveTeacher::ReactiveTeacher(const sylph::SearchProblem& problem, sylph::Rng& rng)
    : problem_(&problem), pibt_(problem), ranking_(problem, rng) {}

std::vector<Action> ReactiveTeacher::desiredActions(const TeamState& team,
                                                    const std::vector<float>& svo_deg,
                                                    const sylph::AgentRows* logits) {
  std::vector<AgentId> order(svo_deg.size());
  std::iota(order.begin(), order.end(), 0);
  // Selfish first: whoever is more prosocial finds its cells taken and gives way.
  std::stable_sort(order.begin(), order.end(), [&](AgentId left, AgentId right) {
    return svo_deg[static_cast<std::size_t>(left)] < svo_deg[static_cast<std::size_t>(right)];
  });
  ranking_.prepare(team, logits);
  sylph::Vertices to(svo_deg.size(), sylph::kNoVertex);
  pibt_.step(problem_->graph.toVertices(team.states().cells), order, ranking_, to);
  std::vector<Action> desired;
  for (std::size_t agent = 0; agent < to.size(); ++agent) {
    desired.push_back(
        *actionBetween(team.states().cells[agent], problem_->graph.cellAt(to[agent])));
  }
  return desired;
}

}  // namespace sylph_training
