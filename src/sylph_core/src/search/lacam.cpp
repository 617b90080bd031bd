#include "sylph_core/search/lacam.hpp"

#include <algorithm>
#include <queue>

#include "sylph_core/search/pibt_steps.hpp"

namespace sylph {
namespace {

/// A step takes the longer the more agents there are: microseconds to milliseconds.
constexpr long kAgentStepsBetweenClockReads = 256;
// Once there is a solution, depth first alone would stay near its end; by judgement.
constexpr std::size_t kStepsBetweenJumps = 64;

}  // namespace

Lacam::Lacam(const SearchProblem& problem, const Vertices& from, ConfigurationGenerator& generator,
             Rng& rng)
    : problem_(&problem), generator_(&generator), rng_(&rng) {
  start_ = addNode(from, hashOf(from), nullptr);
  open_.push_back(start_);
}

Lacam::Status Lacam::search(const Deadline& deadline, long max_steps) {
  const long cost_before = goal_ == nullptr ? 0 : goal_->cost;
  const bool was_solved = isSolved();
  const long between_clock_reads = 1 + kAgentStepsBetweenClockReads / problem_->agentCount();
  long steps = 0;
  for (long iteration = 0; !open_.empty(); ++iteration) {
    if (steps == max_steps || (iteration % between_clock_reads == 0 && deadline.isOver())) {
      return Status::Unfinished;
    }
    if (isSolved() && drawIndex(*rng_, kStepsBetweenJumps) == 0) {
      std::swap(open_[drawIndex(*rng_, open_.size())], open_.back());
    }
    Node& node = *open_.back();
    if (!isWorthwhile(node) || node.next_constraint == node.constraint_tree.size()) {
      open_.pop_back();
      continue;
    }
    if (!isSolved() && node.configuration == problem_->goals) {
      goal_ = &node;
    } else {
      expandOnce(node);
      ++steps;
    }
    if (isSolved() && (!was_solved || goal_->cost < cost_before)) {
      return Status::Solved;
    }
  }
  return Status::Exhausted;
}

bool Lacam::isWorthwhile(const Node& node) const {
  return !isSolved() || node.cost + node.cost_to_go < goal_->cost;
}

void Lacam::expandOnce(Node& node) {
  const std::size_t constraint = node.next_constraint++;
  bind(node, constraint);
  appendChildren(node, constraint);
  if (!node.steps->generate(to_)) {
    return;
  }
  const std::uint64_t hash = hashOf(to_);
  Node* known = findNode(to_, hash);
  if (known == nullptr) {
    known = addNode(to_, hash, &node);
    node.neighbors.push_back(known);
  } else {
    connect(node, *known);
  }
  open_.push_back(known);
}

// Writes the vertices that a constraint and its ancestors bind agents to into to_.
void Lacam::bind(const Node& node, std::size_t constraint) {
  to_.assign(problem_->goals.size(), kNoVertex);
  const std::vector<AgentId>& order = node.steps->order();
  const Constraint* bound = &node.constraint_tree[constraint];
  while (bound->depth > 0) {
    to_[order[bound->depth - 1]] = bound->target;
    bound = &node.constraint_tree[bound->parent];
  }
}

void Lacam::appendChildren(Node& node, std::size_t constraint) {
  const int depth = node.constraint_tree[constraint].depth;
  if (depth == static_cast<int>(problem_->goals.size())) {
    return;
  }
  const VertexId at = node.configuration[node.steps->order()[depth]];
  const Graph::Neighbors neighbors = problem_->graph.neighbors(at);
  Vertices targets(neighbors.begin(), neighbors.end());
  targets.push_back(at);
  shuffle(targets, *rng_);
  for (const VertexId target : targets) {
    if (isConsistent(node, depth, target)) {
      node.constraint_tree.push_back({static_cast<std::int32_t>(constraint), depth + 1, target});
    }
  }
}

// Whether agent order()[depth] may go to `target` along with the agents bound in to_, which are the
// first `depth` in order.
bool Lacam::isConsistent(const Node& node, int depth, VertexId target) const {
  const auto bound_begin = node.steps->order().begin();
  const auto bound_end = bound_begin + depth;
  const VertexId home = node.configuration[node.steps->order()[depth]];
  if (std::any_of(bound_begin, bound_end,
                  [&](const AgentId other) { return to_[other] == target; })) {
    return false;
  }
  // Follow the bound agents that leave the vertex which the one before enters.
  VertexId entered = target;
  for (int length = 2; entered != home; ++length) {
    const auto leaving = std::find_if(bound_begin, bound_end, [&](const AgentId other) {
      return node.configuration[other] == entered && to_[other] != entered;
    });
    if (leaving == bound_end || (problem_->motion.rotations && length > 2)) {
      return true;
    }
    entered = to_[*leaving];
  }
  return target == home;
}

Lacam::Node* Lacam::findNode(const Vertices& configuration, std::uint64_t hash) const {
  const auto [first, last] = explored_.equal_range(hash);
  const auto found = std::find_if(
      first, last, [&](const auto& entry) { return entry.second->configuration == configuration; });
  return found == last ? nullptr : found->second;
}

Lacam::Node* Lacam::addNode(const Vertices& configuration, std::uint64_t hash, Node* parent) {
  Node& node = nodes_.emplace_back();
  node.configuration = configuration;
  node.parent = parent;
  node.priorities = updatePriorities(
      parent == nullptr ? Priorities(problem_->goals.size(), 0) : parent->priorities, configuration,
      problem_->goals);
  node.steps = generator_->enter(
      node.configuration, parent == nullptr ? nullptr : &parent->configuration, node.priorities);
  node.constraint_tree.push_back({0, 0, kNoVertex});
  node.cost = parent == nullptr ? 0 : parent->cost + stepCost(parent->configuration, configuration);
  node.cost_to_go = problem_->distances.sum(configuration);
  explored_.emplace(hash, &node);
  if (nearest_ == nullptr || node.cost_to_go < nearest_->cost_to_go) {
    nearest_ = &node;
  }
  return &node;
}

// Notes a step between known configurations and passes on what it shortens.
void Lacam::connect(Node& from, Node& to) {
  if (std::find(from.neighbors.begin(), from.neighbors.end(), &to) == from.neighbors.end()) {
    from.neighbors.push_back(&to);
  }
  std::queue<Node*> shortened({&from});
  while (!shortened.empty()) {
    Node& node = *shortened.front();
    shortened.pop();
    for (Node* next : node.neighbors) {
      const long cost = node.cost + stepCost(node.configuration, next->configuration);
      if (cost < next->cost) {
        next->cost = cost;
        next->parent = &node;
        shortened.push(next);
        if (isSolved() && isWorthwhile(*next)) {
          open_.push_back(next);
        }
      }
    }
  }
}

void Lacam::insert(const std::vector<Vertices>& plan, const Deadline& deadline) {
  Node* node = start_;
  for (std::size_t timestep = 1; timestep < plan.size() && !deadline.isOver(); ++timestep) {
    const std::uint64_t hash = hashOf(plan[timestep]);
    Node* next = findNode(plan[timestep], hash);
    if (next == nullptr) {
      next = addNode(plan[timestep], hash, node);
      node->neighbors.push_back(next);
      open_.push_back(next);
    } else {
      connect(*node, *next);
    }
    node = next;
  }
  if (node->configuration == problem_->goals) {
    goal_ = node;
  }
}

long Lacam::stepCost(const Vertices& from, const Vertices& to) const {
  long cost = 0;
  for (std::size_t agent = 0; agent < problem_->goals.size(); ++agent) {
    cost += from[agent] != problem_->goals[agent] || to[agent] != problem_->goals[agent] ? 1 : 0;
  }
  return cost;
}

std::vector<Vertices> Lacam::plan() const {
  std::vector<Vertices> plan;
  for (const Node* node = isSolved() ? goal_ : nearest_; node != nullptr; node = node->parent) {
    plan.push_back(node->configuration);
  }
  std::reverse(plan.begin(), plan.end());
  return plan;
}

}  // namespace sylph
