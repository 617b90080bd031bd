#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph_training {

/// What an action costs more than the best one, in timesteps not at rest on the goal, in the order
/// of sylph::Action; kImpossible for actions that hit something, and at most kGreatestRegret.
using Regrets = std::array<std::uint8_t, sylph::kActionCount>;

constexpr std::uint8_t kImpossible = 255;
constexpr std::uint8_t kGreatestRegret = 254;

/// How good each action of one agent would have been while all others follow a plan.
///
/// For an agent and a plan of T + 1 configurations, by backward induction over time,
///
///     V_T(v) = distance of v to the goal
///     V_t(v) = min over moves v -> u that are legal beside the others' moves of
///              [not v = u = goal] + V_(t+1)(u)
///
/// and the regret of an action at timestep t is its term of that minimum less the minimum, at the
/// vertex where the plan has the agent. Only vertices up to kRadius rows and columns away from the
/// agent's own path at the same timestep are looked at, so an agent costs O(T), not O(T |V|).
class RegretTable {
 public:
  static constexpr int kRadius = 6;

  /// @param problem  must outlive this object
  /// @param plan     a legal plan, all of it kept
  RegretTable(const sylph::SearchProblem& problem, std::vector<sylph::Vertices> plan);

  /// Regrets of one agent at each joint action of the plan: plan.size() - 1 entries.
  std::vector<Regrets> of(sylph::AgentId agent) const;

 private:
  class Window;

  bool isLegal(sylph::AgentId agent, std::size_t timestep, sylph::VertexId from,
               sylph::VertexId to) const;
  bool isTaken(sylph::AgentId agent, std::size_t timestep, sylph::VertexId vertex) const;

  const sylph::SearchProblem* problem_;
  std::vector<sylph::Vertices> plan_;
  std::vector<std::vector<sylph::AgentId>> occupants_;  // per timestep and vertex
};

}  // namespace sylph_training
