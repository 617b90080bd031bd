#include "sylph_core/search/neighborhoods.hpp"

#include <algorithm>
#include <numeric>

namespace sylph {
namespace {

int drawBelow(int bound, Rng& rng) {
  return static_cast<int>(drawIndex(rng, static_cast<std::size_t>(bound)));
}

}  // namespace

Neighborhoods::Neighborhoods(const SearchProblem& problem, const ReservationTable& table,
                             const ImprovementSettings& settings)
    : problem_(&problem),
      table_(&table),
      walks_(settings.walks),
      jam_reach_(settings.jam_reach),
      is_picked_(problem.goals.size(), false),
      is_seen_(static_cast<std::size_t>(problem.graph.size()), false) {}

std::vector<AgentId> Neighborhoods::pick(NeighborhoodKind kind, int size, Rng& rng) {
  beginPick();
  switch (kind) {
    case NeighborhoodKind::Delayed:
      return pickDelayed(size, rng);
    case NeighborhoodKind::Crossing:
      return pickCrossing(size, rng);
    case NeighborhoodKind::Jam:
      return pickJam(size, rng);
    case NeighborhoodKind::Random:
      break;
  }
  return pickRandom(size, rng);
}

void Neighborhoods::beginPick() {
  for (const AgentId agent : picked_) {
    is_picked_[agent] = false;
  }
  picked_.clear();
}

void Neighborhoods::add(AgentId agent) {
  if (agent != kNoAgent && !is_picked_[agent]) {
    is_picked_[agent] = true;
    picked_.push_back(agent);
  }
}

int Neighborhoods::delayOf(AgentId agent) const {
  const VertexPath& path = table_->path(agent);
  return static_cast<int>(path.size()) - 1 - problem_->distances.get(agent, path.front());
}

std::vector<AgentId> Neighborhoods::pickRandom(int size, Rng& rng) const {
  std::vector<AgentId> agents(problem_->goals.size());
  std::iota(agents.begin(), agents.end(), 0);
  for (int index = 0; index < size; ++index) {
    std::swap(agents[index], agents[index + drawBelow(agentCount() - index, rng)]);
  }
  agents.resize(static_cast<std::size_t>(size));
  return agents;
}

// An agent with probability in proportion to its delay.
AgentId Neighborhoods::drawDelayedAgent(Rng& rng) const {
  return static_cast<AgentId>(drawByWeight(rng, problem_->goals.size(), [&](std::size_t agent) {
    return delayOf(static_cast<AgentId>(agent));
  }));
}

std::vector<AgentId> Neighborhoods::pickDelayed(int size, Rng& rng) {
  AgentId agent = drawDelayedAgent(rng);
  add(agent);
  for (int walks = 0; walks < walks_ && !isFull(size); ++walks) {
    walk(agent, size, rng);
    agent = picked_[drawBelow(static_cast<int>(picked_.size()), rng)];
  }
  return picked_;
}

// Leaves the agent's path at random for moves that would let it arrive earlier, and picks the
// agents that are in the way of them.
void Neighborhoods::walk(AgentId agent, int size, Rng& rng) {
  const VertexPath& path = table_->path(agent);
  const auto cost = static_cast<Timestep>(path.size()) - 1;
  if (cost == 0) {
    return;
  }
  Timestep timestep = drawBelow(cost, rng);
  VertexId vertex = path[timestep];
  while (timestep < cost && !isFull(size)) {
    std::array<VertexId, 5> shorter{};
    int count = 0;
    const auto consider = [&](VertexId target) {
      if (timestep + 1 + problem_->distances.get(agent, target) < cost) {
        shorter[count++] = target;
      }
    };
    consider(vertex);
    for (const VertexId target : problem_->graph.neighbors(vertex)) {
      consider(target);
    }
    if (count == 0) {
      return;
    }
    const VertexId target = shorter[drawBelow(count, rng)];
    add(table_->occupant(target, timestep + 1));
    const AgentId opposite = table_->occupant(target, timestep);
    if (opposite != kNoAgent && !isFull(size) &&
        table_->position(opposite, timestep + 1) == vertex) {
      add(opposite);
    }
    vertex = target;
    ++timestep;
  }
}

template <typename AddVisitors>
void Neighborhoods::pickAround(VertexId center, int size, AddVisitors addVisitors) {
  frontier_ = {center};
  is_seen_[center] = true;
  for (std::size_t next = 0; next < frontier_.size() && !isFull(size); ++next) {
    const VertexId vertex = frontier_[next];
    addVisitors(vertex);
    for (const VertexId neighbor : problem_->graph.neighbors(vertex)) {
      if (!is_seen_[neighbor]) {
        is_seen_[neighbor] = true;
        frontier_.push_back(neighbor);
      }
    }
  }
  for (const VertexId vertex : frontier_) {
    is_seen_[vertex] = false;
  }
}

std::vector<AgentId> Neighborhoods::pickCrossing(int size, Rng& rng) {
  const VertexPath& path = table_->path(drawBelow(agentCount(), rng));
  const VertexId center = path[drawBelow(static_cast<int>(path.size()), rng)];
  const Timestep horizon = table_->horizon();
  pickAround(center, size, [&](VertexId vertex) {
    const Timestep begin = drawBelow(horizon + 1, rng);
    for (Timestep offset = 0; offset <= horizon && !isFull(size); ++offset) {
      add(table_->occupant(vertex, (begin + offset) % (horizon + 1)));
    }
  });
  return picked_;
}

std::vector<AgentId> Neighborhoods::pickJam(int size, Rng& rng) {
  const AgentId delayed = drawDelayedAgent(rng);
  const VertexPath& path = table_->path(delayed);
  add(delayed);
  Timestep center = drawBelow(static_cast<int>(path.size()), rng);
  // On to the next step that brings the agent no nearer to its goal.
  while (center + 1 < static_cast<Timestep>(path.size()) &&
         problem_->distances.get(delayed, path[center + 1]) <
             problem_->distances.get(delayed, path[center])) {
    ++center;
  }
  const Timestep first = std::max(0, center - jam_reach_);
  const Timestep last = std::min(table_->horizon(), center + jam_reach_);
  pickAround(path[center], size, [&](VertexId vertex) {
    for (Timestep timestep = first; timestep <= last && !isFull(size); ++timestep) {
      add(table_->occupant(vertex, timestep));
    }
  });
  return picked_;
}

}  // namespace sylph
