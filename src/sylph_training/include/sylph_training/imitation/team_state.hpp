#pragma once

#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/policy/observation.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph_training {

/// A team on its way, step by step, whose SVOs follow the rule of priorities.
class TeamState {
 public:
  /// @param problem     of the instance; both must outlive this object
  /// @param tie_breaks  per agent, 0 ... 1
  TeamState(const sylph::Instance& instance, const sylph::SearchProblem& problem,
            std::vector<float> tie_breaks);

  const sylph::Instance& instance() const { return *instance_; }
  const sylph::SearchProblem& problem() const { return *problem_; }
  /// Number of agents.
  int agentCount() const { return instance_->agentCount(); }

  /// Cells, last moves, SVOs by svoByPriority(), priorities.
  const sylph::AgentStates& states() const { return states_; }
  /// Where the agents were one timestep ago; at the start, where they are.
  const sylph::Configuration& before() const { return before_; }

  bool isHome(sylph::AgentId agent) const;
  /// Whether everybody is on its goal.
  bool isSolved() const;
  /// Whether an action hits neither an obstacle nor the edge.
  bool isValid(sylph::AgentId agent, sylph::Action action) const;
  /// Whether an action comes closer to the goal; on the goal, whether it stays there.
  bool isGreedy(sylph::AgentId agent, sylph::Action action) const;

  /// One timestep: everybody's desired action, less what tie-breaking takes out (He et al. 2024,
  /// Alg. 3).
  /// @param svo_deg  that ties are broken by, one per agent [deg]
  void move(const std::vector<sylph::Action>& desired, const std::vector<float>& svo_deg);

 private:
  void updateSvo();

  const sylph::Instance* instance_;
  const sylph::SearchProblem* problem_;
  sylph::AgentStates states_;
  sylph::Configuration before_;
};

}  // namespace sylph_training
