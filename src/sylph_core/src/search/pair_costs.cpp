#include "sylph_core/search/pair_costs.hpp"

#include <algorithm>
#include <utility>

namespace sylph {
namespace {

/// About 20 MB, filled within a fifth of a second.
constexpr double kMostEntries = 5e6;

double entriesOf(const SearchProblem& problem) {
  const double agents = problem.agentCount();
  const double vertices = problem.graph.size();
  return agents * (agents - 1.0) / 2.0 * vertices * vertices;
}

/// Entries by cost, the cheapest first.
class BucketQueue {
 public:
  explicit BucketQueue(std::vector<int>& costs) : costs_(&costs) {}

  /// An entry costs no more than this.
  void relax(std::size_t entry, int cost) {
    if (cost >= (*costs_)[entry]) {
      return;
    }
    (*costs_)[entry] = cost;
    const auto bucket = static_cast<std::size_t>(cost);
    if (buckets_.size() <= bucket) {
      buckets_.resize(bucket + 1);
    }
    buckets_[bucket].push_back(entry);
  }

  /// @param visit  takes entry and cost, and may relax others to no less than this cost
  /// @return false if the time was over before all were visited
  template <typename Visit>
  bool forEach(const Deadline& deadline, const Visit& visit) {
    constexpr long kVisitsPerQuestion = 4096;
    long visits = 0;
    for (std::size_t cost = 0; cost < buckets_.size(); ++cost) {
      for (std::size_t i = 0; i < buckets_[cost].size(); ++i) {
        if (++visits % kVisitsPerQuestion == 0 && deadline.isOver()) {
          return false;
        }
        const std::size_t entry = buckets_[cost][i];
        if ((*costs_)[entry] == static_cast<int>(cost)) {
          visit(entry, static_cast<int>(cost));
        }
      }
    }
    return true;
  }

 private:
  std::vector<int>* costs_;
  std::vector<std::vector<std::size_t>> buckets_;
};

}  // namespace

PairCosts::PairCosts(const SearchProblem& problem)
    : problem_(&problem),
      beside_arrived_(static_cast<std::size_t>(problem.agentCount() * problem.agentCount())),
      both_(beside_arrived_.size()) {}

std::optional<PairCosts> PairCosts::compute(const SearchProblem& problem,
                                            const Deadline& deadline) {
  if (entriesOf(problem) > kMostEntries) {
    return std::nullopt;
  }
  PairCosts costs(problem);
  for (AgentId b = 0; b < problem.agentCount(); ++b) {
    for (AgentId a = 0; a < b; ++a) {
      if (deadline.isOver() || !costs.computeBesideArrived(a, b, deadline) ||
          !costs.computeBesideArrived(b, a, deadline) || !costs.computePair(a, b, deadline)) {
        return std::nullopt;
      }
    }
  }
  return costs;
}

bool PairCosts::computeBesideArrived(AgentId arrived, AgentId moving, const Deadline& deadline) {
  std::vector<int>& costs = besideArrived(arrived, moving);
  costs.assign(static_cast<std::size_t>(problem_->graph.size()), kNoWay);
  BucketQueue queue(costs);
  queue.relax(static_cast<std::size_t>(problem_->goals[moving]), 0);
  return queue.forEach(deadline, [&](std::size_t vertex, int cost) {
    for (const VertexId neighbor : problem_->graph.neighbors(static_cast<VertexId>(vertex))) {
      if (neighbor != problem_->goals[arrived]) {
        queue.relax(static_cast<std::size_t>(neighbor), cost + 1);
      }
    }
  });
}

bool PairCosts::computePair(AgentId a, AgentId b, const Deadline& deadline) {
  const Graph& graph = problem_->graph;
  const int size = graph.size();
  std::vector<int>& costs = both_[static_cast<std::size_t>(a * problem_->agentCount() + b)];
  costs.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), kNoWay);
  BucketQueue queue(costs);
  const auto entry = [size](VertexId of_a, VertexId of_b) {
    return static_cast<std::size_t>(of_a) * static_cast<std::size_t>(size) +
           static_cast<std::size_t>(of_b);
  };
  for (VertexId vertex = 0; vertex < size; ++vertex) {
    const auto slot = static_cast<std::size_t>(vertex);
    if (vertex != problem_->goals[a]) {
      queue.relax(entry(problem_->goals[a], vertex), besideArrived(a, b)[slot]);
    }
    if (vertex != problem_->goals[b]) {
      queue.relax(entry(vertex, problem_->goals[b]), besideArrived(b, a)[slot]);
    }
  }
  return queue.forEach(deadline, [&](std::size_t at, int cost) {
    const auto of_a = static_cast<VertexId>(at / static_cast<std::size_t>(size));
    const auto of_b = static_cast<VertexId>(at % static_cast<std::size_t>(size));
    const auto relax = [&](VertexId from_a, VertexId from_b) {
      const bool is_swap = from_a == of_b && from_b == of_a;
      if (from_a != from_b && !is_swap) {
        queue.relax(entry(from_a, from_b), cost + 2);
      }
    };
    const auto relaxFrom = [&](VertexId from_a) {
      relax(from_a, of_b);
      for (const VertexId from_b : graph.neighbors(of_b)) {
        relax(from_a, from_b);
      }
    };
    relaxFrom(of_a);
    for (const VertexId from_a : graph.neighbors(of_a)) {
      relaxFrom(from_a);
    }
  });
}

int PairCosts::delay(AgentId a, const AgentPlace& from_a, AgentId b,
                     const AgentPlace& from_b) const {
  if (a > b) {
    return delay(b, from_b, a, from_a);
  }
  const DistanceTables& distances = problem_->distances;
  int cost = 0;
  if (from_a.has_arrived && from_b.has_arrived) {
    return 0;
  }
  if (from_a.has_arrived) {
    cost = besideArrived(a, b)[static_cast<std::size_t>(from_b.vertex)];
    return cost == kNoWay ? kNoWay : cost - distances.get(b, from_b.vertex);
  }
  if (from_b.has_arrived) {
    cost = besideArrived(b, a)[static_cast<std::size_t>(from_a.vertex)];
    return cost == kNoWay ? kNoWay : cost - distances.get(a, from_a.vertex);
  }
  const std::vector<int>& costs = both_[static_cast<std::size_t>(a * problem_->agentCount() + b)];
  cost = costs[static_cast<std::size_t>(from_a.vertex) *
                   static_cast<std::size_t>(problem_->graph.size()) +
               static_cast<std::size_t>(from_b.vertex)];
  return cost == kNoWay ? kNoWay
                        : cost - distances.get(a, from_a.vertex) - distances.get(b, from_b.vertex);
}

}  // namespace sylph
