#include "sylph_training/imitation/regrets.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace sylph_training {
namespace {

using sylph::AgentId;
using sylph::VertexId;

constexpr int kNever = std::numeric_limits<int>::max() / 2;

VertexId neighborOf(const sylph::Graph& graph, VertexId vertex, sylph::Action action) {
  const sylph::Cell cell = sylph::neighbor(graph.cellAt(vertex), action);
  const bool is_inside =
      cell.row >= 0 && cell.row < graph.rows() && cell.col >= 0 && cell.col < graph.cols();
  return is_inside ? graph.vertexAt(cell) : sylph::kNoVertex;
}

/// How much dearer each action is than the best of them.
Regrets regretsOf(const std::array<int, sylph::kActionCount>& costs) {
  Regrets regrets{};
  // Against the best and not against the expert's own: it is not optimal either.
  const int best = *std::min_element(costs.begin(), costs.end());
  for (std::size_t action = 0; action < costs.size(); ++action) {
    const int regret = std::min(costs[action] - best, static_cast<int>(kGreatestRegret));
    regrets[action] = costs[action] == kNever ? kImpossible : static_cast<std::uint8_t>(regret);
  }
  return regrets;
}

}  // namespace

/// Costs to come of the vertices round a center.
class RegretTable::Window {
 public:
  Window(const sylph::Graph& graph, VertexId center)
      : graph_(&graph), center_(graph.cellAt(center)) {
    costs_.fill(kNever);
  }

  int get(VertexId vertex) const {
    const sylph::Cell& cell = graph_->cellAt(vertex);
    const int row = cell.row - center_.row + kRadius;
    const int col = cell.col - center_.col + kRadius;
    return row < 0 || row >= kSide || col < 0 || col >= kSide
               ? kNever
               : costs_[static_cast<std::size_t>(row * kSide + col)];
  }

  /// Sets the cost of each vertex in the window to what `cost` says.
  template <typename Cost>
  void fill(Cost cost) {
    for (int index = 0; index < kSide * kSide; ++index) {
      const sylph::Cell cell{center_.row - kRadius + index / kSide,
                             center_.col - kRadius + index % kSide};
      const bool is_inside =
          cell.row >= 0 && cell.row < graph_->rows() && cell.col >= 0 && cell.col < graph_->cols();
      const VertexId vertex = is_inside ? graph_->vertexAt(cell) : sylph::kNoVertex;
      costs_[static_cast<std::size_t>(index)] = vertex == sylph::kNoVertex ? kNever : cost(vertex);
    }
  }

 private:
  static constexpr int kSide = 2 * kRadius + 1;

  const sylph::Graph* graph_;
  sylph::Cell center_;
  std::array<int, kSide * kSide> costs_{};
};

RegretTable::RegretTable(const sylph::SearchProblem& problem, std::vector<sylph::Vertices> plan)
    : problem_(&problem), plan_(std::move(plan)) {
  for (const sylph::Vertices& configuration : plan_) {
    std::vector<AgentId> occupants(static_cast<std::size_t>(problem.graph.size()), sylph::kNoAgent);
    for (std::size_t agent = 0; agent < configuration.size(); ++agent) {
      occupants[static_cast<std::size_t>(configuration[agent])] = static_cast<AgentId>(agent);
    }
    occupants_.push_back(std::move(occupants));
  }
}

bool RegretTable::isTaken(AgentId agent, std::size_t timestep, VertexId vertex) const {
  const AgentId occupant = occupants_[timestep][static_cast<std::size_t>(vertex)];
  return occupant != sylph::kNoAgent && occupant != agent;
}

// Follows whoever leaves the vertex that is entered: a chain that comes back to where the agent
// starts is a swap or, if longer, a rotation.
bool RegretTable::isLegal(AgentId agent, std::size_t timestep, VertexId from, VertexId to) const {
  if (isTaken(agent, timestep + 1, to)) {
    return false;
  }
  VertexId at = to;
  while (at != from && isTaken(agent, timestep, at)) {
    const AgentId other = occupants_[timestep][static_cast<std::size_t>(at)];
    const VertexId next = plan_[timestep + 1][static_cast<std::size_t>(other)];
    if (next == from) {
      return false;
    }
    if (problem_->motion.rotations || next == at) {
      break;
    }
    at = next;
  }
  return true;
}

std::vector<Regrets> RegretTable::of(AgentId agent) const {
  const auto self = static_cast<std::size_t>(agent);
  const VertexId goal = problem_->goals[self];
  std::vector<Regrets> regrets(plan_.size() - 1);
  Window later(problem_->graph, plan_.back()[self]);
  later.fill([&](VertexId vertex) { return problem_->distances.get(agent, vertex); });
  for (std::size_t timestep = plan_.size() - 1; timestep-- > 0;) {
    const auto costOf = [&](VertexId from, VertexId to) {
      const int rest = later.get(to);
      return rest == kNever || !isLegal(agent, timestep, from, to)
                 ? kNever
                 : rest + (from == goal && to == goal ? 0 : 1);
    };
    const VertexId at = plan_[timestep][self];
    std::array<int, sylph::kActionCount> costs{};
    for (const sylph::Action action : sylph::kActions) {
      const VertexId to = neighborOf(problem_->graph, at, action);
      costs[static_cast<std::size_t>(action)] = to == sylph::kNoVertex ? kNever : costOf(at, to);
    }
    regrets[timestep] = regretsOf(costs);
    Window now(problem_->graph, at);
    now.fill([&](VertexId from) {
      int cost = isTaken(agent, timestep, from) ? kNever : costOf(from, from);
      if (!isTaken(agent, timestep, from)) {
        for (const VertexId to : problem_->graph.neighbors(from)) {
          cost = std::min(cost, costOf(from, to));
        }
      }
      return cost;
    });
    later = now;
  }
  return regrets;
}

}  // namespace sylph_training
