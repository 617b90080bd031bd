#include "sylph_core/search/large_neighborhood_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sylph {
namespace {

// Room for agents to arrive somewhat later than the last one does now.
int horizonFor(int makespan) {
  return makespan + makespan / 16 + 4;
}

}  // namespace

double LargeNeighborhoodSearch::bytesOf(const SearchProblem& problem, int makespan) {
  return ReservationTable::bytesOf(problem.graph, horizonFor(makespan));
}

LargeNeighborhoodSearch::LargeNeighborhoodSearch(const SearchProblem& problem,
                                                 const std::vector<Vertices>& plan,
                                                 long proved_sum_of_costs,
                                                 const ImprovementSettings& settings)
    : problem_(&problem),
      settings_(settings),
      table_(problem.graph, problem.motion, problem.agentCount(), 1),
      search_(problem.graph),
      neighborhoods_(problem, table_, settings),
      lower_bound_(std::max(proved_sum_of_costs, problem.distances.sum(problem.starts))) {
  const int agents = problem.agentCount();
  for (const NeighborhoodKind kind : kNeighborhoodKinds) {
    for (const int size : settings.neighborhood_sizes) {
      if (size <= std::max(agents, settings.neighborhood_sizes.front())) {
        arms_.push_back({kind, std::min(size, agents)});
      }
    }
  }
  take(pathsOf(plan));
}

void LargeNeighborhoodSearch::offer(const std::vector<Vertices>& plan) {
  std::vector<VertexPath> paths = pathsOf(plan);
  if (sumOfCosts(paths) < best_cost_) {
    ++improvements_;
    take(std::move(paths));
  }
}

void LargeNeighborhoodSearch::take(std::vector<VertexPath> paths) {
  fillTable(paths);
  cost_ = sumOfCosts(paths);
  best_cost_ = cost_;
  best_paths_ = std::move(paths);
}

void LargeNeighborhoodSearch::run(const Deadline& deadline, double temperature, Rng& rng) {
  double before_s = deadline.elapsed();
  for (long iteration = 1; best_cost_ > lower_bound_ && !deadline.isOver(); ++iteration) {
    Arm& arm = arms_[drawArm(rng)];
    // Drawn from an exponential distribution: accepted with the probability of simulated annealing,
    // but the path search knows beforehand how much it may spend.
    const auto allowed_loss = static_cast<long>(-temperature * std::log(1.0 - drawFraction(rng)));
    const long cost_before = cost_;
    replan(neighborhoods_.pick(arm.kind, arm.size, rng), allowed_loss, deadline, rng);
    keepIfBest();
    if (iteration % settings_.neighborhoods_between_shrinks == 0 &&
        deadline.remaining() > bytesOf(*problem_, table_.horizon()) / settings_.table_bytes_per_s) {
      shrinkTable();
    }
    // By time and not by number: large neighbourhoods gain more, and take longer.
    const double now_s = deadline.elapsed();
    const auto gain = static_cast<double>(std::max(0L, cost_before - cost_));
    arm.gain_per_s +=
        settings_.reaction_factor * (gain / std::max(now_s - before_s, 1e-6) - arm.gain_per_s);
    before_s = now_s;
  }
}

std::size_t LargeNeighborhoodSearch::drawArm(Rng& rng) const {
  if (drawFraction(rng) < settings_.exploration) {
    return drawIndex(rng, arms_.size());
  }
  return drawByWeight(rng, arms_.size(),
                      [&](std::size_t index) { return arms_[index].gain_per_s; });
}

// @return whether the agents have new paths; otherwise they keep their old ones
bool LargeNeighborhoodSearch::replan(std::vector<AgentId> agents, long allowed_loss,
                                     const Deadline& deadline, Rng& rng) {
  shuffle(agents, rng);
  std::vector<VertexPath> old_paths;
  long old_cost = 0;
  long least_cost = 0;
  for (const AgentId agent : agents) {
    old_paths.push_back(table_.path(agent));
    old_cost += costOf(agent);
    least_cost += leastCostOf(agent);
  }
  // None of them can arrive earlier.
  if (old_cost == least_cost) {
    return false;
  }
  for (const AgentId agent : agents) {
    table_.remove(agent);
  }
  if (planAll(agents, old_cost + allowed_loss, deadline, rng)) {
    for (const AgentId agent : agents) {
      cost_ += costOf(agent);
    }
    cost_ -= old_cost;
    return true;
  }
  for (std::size_t index = 0; index < agents.size(); ++index) {
    table_.insert(agents[index], old_paths[index]);
  }
  return false;
}

// Prioritised planning. Leaves none of the agents in the table where not all of them can be planned
// at that cost.
bool LargeNeighborhoodSearch::planAll(const std::vector<AgentId>& agents, long max_cost,
                                      const Deadline& deadline, Rng& rng) {
  long least_cost_of_rest = 0;
  for (const AgentId agent : agents) {
    least_cost_of_rest += leastCostOf(agent);
  }
  long cost = 0;
  for (auto agent = agents.begin(); agent != agents.end(); ++agent) {
    least_cost_of_rest -= leastCostOf(*agent);
    // What the agents after it need at least is set aside, so that a search which cannot come to
    // less ends early.
    const long latest_arrival =
        std::min<long>(table_.horizon(), max_cost - cost - least_cost_of_rest);
    const VertexPath path = search_.find(table_, problem_->starts[*agent], problem_->goals[*agent],
                                         static_cast<Timestep>(latest_arrival), deadline, rng);
    if (path.empty()) {
      std::for_each(agents.begin(), agent, [&](const AgentId planned) { table_.remove(planned); });
      return false;
    }
    cost += static_cast<long>(path.size()) - 1;
    table_.insert(*agent, path);
  }
  return true;
}

void LargeNeighborhoodSearch::keepIfBest() {
  if (cost_ >= best_cost_) {
    return;
  }
  ++improvements_;
  best_cost_ = cost_;
  for (AgentId agent = 0; agent < problem_->agentCount(); ++agent) {
    best_paths_[agent] = table_.path(agent);
  }
}

void LargeNeighborhoodSearch::fillTable(const std::vector<VertexPath>& paths) {
  std::size_t longest = 1;
  for (const VertexPath& path : paths) {
    longest = std::max(longest, path.size());
  }
  table_ = ReservationTable(problem_->graph, problem_->motion, problem_->agentCount(),
                            horizonFor(static_cast<int>(longest) - 1));
  for (AgentId agent = 0; agent < problem_->agentCount(); ++agent) {
    table_.insert(agent, paths[agent]);
  }
}

// Paths get shorter, and layers after the last arrival only cost time.
void LargeNeighborhoodSearch::shrinkTable() {
  int makespan = 0;
  for (AgentId agent = 0; agent < problem_->agentCount(); ++agent) {
    makespan = std::max(makespan, costOf(agent));
  }
  // Filling a table is as dear as many neighbourhoods: only where a tenth is to be had.
  if (horizonFor(makespan) * 10 < table_.horizon() * 9) {
    std::vector<VertexPath> paths;
    paths.reserve(static_cast<std::size_t>(problem_->agentCount()));
    for (AgentId agent = 0; agent < problem_->agentCount(); ++agent) {
      paths.push_back(table_.path(agent));
    }
    fillTable(paths);
  }
}

}  // namespace sylph
