#include "sylph_core/search/large_neighborhood_search.hpp"

#include <algorithm>
#include <utility>

namespace sylph {
namespace {

constexpr std::array<int, 5> kSizes = {2, 4, 8, 16, 32};  // agents in a neighbourhood

// The agent's vertices up to its last arrival.
VertexPath pathOf(const std::vector<Vertices>& plan, AgentId agent) {
  std::size_t length = plan.size();
  while (length > 1 && plan[length - 2][agent] == plan.back()[agent]) {
    --length;
  }
  VertexPath path(length);
  for (std::size_t timestep = 0; timestep < length; ++timestep) {
    path[timestep] = plan[timestep][agent];
  }
  return path;
}

}  // namespace

LargeNeighborhoodSearch::LargeNeighborhoodSearch(const SearchProblem& problem,
                                                 const std::vector<Vertices>& plan)
    : problem_(&problem),
      table_(problem.graph, problem.motion, problem.agentCount(), static_cast<int>(plan.size())),
      search_(problem.graph),
      neighborhoods_(problem.graph, problem.goals, problem.distances, table_) {
  for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
    table_.insert(agent, pathOf(plan, agent));
    cost_ += costOf(agent);
    lower_bound_ += problem.distances.get(agent, problem.starts[agent]);
  }
  for (const NeighborhoodKind kind : kNeighborhoodKinds) {
    for (const int size : kSizes) {
      if (size <= std::max(problem.agentCount(), kSizes.front())) {
        arms_.push_back({kind, std::min(size, problem.agentCount()), 1.0});
      }
    }
  }
}

void LargeNeighborhoodSearch::run(const Deadline& deadline, Rng& rng) {
  constexpr double kForgetting = 0.01;
  double before = deadline.elapsed();
  while (cost_ > lower_bound_ && !deadline.isOver()) {
    ++iterations_;
    const long cost_before = cost_;
    const std::size_t arm = drawArm(rng);
    improve(neighborhoods_.pick(arms_[arm].kind, arms_[arm].size, rng), rng);
    improvements_ += cost_ < cost_before ? 1 : 0;
    const double now = deadline.elapsed();
    const double gain_per_s =
        static_cast<double>(cost_before - cost_) / std::max(now - before, 1e-6);
    before = now;
    arms_[arm].weight += kForgetting * (gain_per_s - arms_[arm].weight);
  }
}

std::size_t LargeNeighborhoodSearch::drawArm(Rng& rng) const {
  double total = 0.0;
  for (const Arm& arm : arms_) {
    total += arm.weight;
  }
  constexpr double kExploration = 0.2;
  const double share = static_cast<double>(rng()) / 4294967296.0;
  if (total <= 0.0 || share < kExploration) {
    return rng() % arms_.size();
  }
  double ticket = static_cast<double>(rng()) / 4294967296.0 * total;
  std::size_t arm = 0;
  while (arm + 1 < arms_.size() && ticket >= arms_[arm].weight) {
    ticket -= arms_[arm].weight;
    ++arm;
  }
  return arm;
}

bool LargeNeighborhoodSearch::improve(std::vector<AgentId> agents, Rng& rng) {
  std::shuffle(agents.begin(), agents.end(), rng);
  std::vector<VertexPath> old_paths;
  long old_cost = 0;
  long least_cost = 0;
  for (const AgentId agent : agents) {
    old_cost += costOf(agent);
    least_cost += problem_->distances.get(agent, problem_->starts[agent]);
    old_paths.push_back(table_.path(agent));
  }
  if (old_cost == least_cost) {
    return false;
  }
  for (const AgentId agent : agents) {
    table_.remove(agent);
  }
  long new_cost = 0;
  std::size_t planned = 0;
  for (; planned < agents.size(); ++planned) {
    const AgentId agent = agents[planned];
    least_cost -= problem_->distances.get(agent, problem_->starts[agent]);
    const VertexPath path = search_.find(
        table_, problem_->starts[agent], problem_->goals[agent],
        static_cast<Timestep>(std::min<long>(table_.horizon(), old_cost - new_cost - least_cost)),
        rng);
    if (path.empty()) {
      break;
    }
    new_cost += static_cast<long>(path.size()) - 1;
    table_.insert(agent, path);
  }
  if (planned == agents.size()) {
    cost_ += new_cost - old_cost;
    return true;
  }
  for (std::size_t index = 0; index < planned; ++index) {
    table_.remove(agents[index]);
  }
  for (std::size_t index = 0; index < agents.size(); ++index) {
    table_.insert(agents[index], old_paths[index]);
  }
  return false;
}

std::vector<Vertices> LargeNeighborhoodSearch::plan() const {
  std::size_t length = 1;
  for (AgentId agent = 0; agent < problem_->agentCount(); ++agent) {
    length = std::max(length, table_.path(agent).size());
  }
  std::vector<Vertices> plan(length, Vertices(problem_->starts.size()));
  for (std::size_t timestep = 0; timestep < length; ++timestep) {
    for (AgentId agent = 0; agent < problem_->agentCount(); ++agent) {
      plan[timestep][agent] = table_.position(agent, static_cast<Timestep>(timestep));
    }
  }
  return plan;
}

}  // namespace sylph
