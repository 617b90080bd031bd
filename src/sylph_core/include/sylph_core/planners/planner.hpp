#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/social/social_state.hpp"

namespace sylph {

class Policy;

/// What a planner may spend.
struct PlanningLimits {
  double time_limit_s = 5.0;         ///< wall time [s], > 0
  int max_steps = 10000;             ///< longest plan that is of use [timesteps], > 0
  bool first_solution_only = false;  ///< stop at the first solution instead of improving it
  bool social_states = true;         ///< whether partners and SVOs along the plan are wanted
  int threads = 1;                   ///< > 0
  Clock clock = steadyTime;          ///< by which the time limit goes: another one in tests
};

/// How a planner ended.
enum class Outcome {
  Solved,      ///< the plan reaches all goals
  TimeLimit,   ///< no plan found in the time given
  StepLimit,   ///< no plan found within max_steps
  Unsolvable,  ///< proved: there is no plan
};

std::string toString(Outcome outcome);

/// What planning took.
struct PlanningStatistics {
  double first_solution_s = 0.0;  ///< wall time until the first solution [s]
  double total_s = 0.0;           ///< wall time of the whole call [s]
  long search_nodes = 0;          ///< configurations generated
  long improvements = 0;          ///< times a better plan replaced the best one
  long policy_calls = 0;          ///< network evaluations of one joint configuration
  /// Sum of the distances from starts to goals; nothing if the time was over before.
  std::optional<long> sum_of_costs_lower_bound;
  /// No plan has less, as far as the planner looked: at least the sum of distances, at most the sum
  /// of costs of the plan, which then is the least. Nothing if it did not look.
  std::optional<long> proved_sum_of_costs;
};

/// What a planner found, and what it took.
struct PlanningResult {
  /// Best plan; if not solved, as far as the planner came, of max_steps at most.
  Plan plan;
  /// One per joint action, plan.size() - 1; fewer, the first ones, where the time was over before.
  std::vector<SocialState> social;
  Outcome outcome = Outcome::TimeLimit;  ///< Solved: the plan is a solution
  PlanningStatistics statistics;         ///< what it took
};

/// Plans instances, without memory of those before: calls do not depend on each other.
class Planner {
 public:
  virtual ~Planner() = default;

  /// Plans an instance that requireValid() accepts.
  virtual PlanningResult plan(const Instance& instance, const PlanningLimits& limits,
                              Rng& rng) const = 0;
  /// By which makePlanner() knows it, with its ablation if there is one.
  virtual std::string name() const = 0;
};

/// Names that makePlanner() accepts, the default first.
const std::vector<std::string>& plannerNames();

/// Whether a planner is guided by a policy network. False for unknown names.
bool needsPolicy(const std::string& planner_name);

/// The policy that a planner needs, nullptr if it needs none.
/// @throws std::invalid_argument if it needs one and the path is empty
/// @throws std::runtime_error as Policy::load()
std::shared_ptr<const Policy> loadPolicyFor(const std::string& planner_name,
                                            const std::string& weights_path);

/// What a policy-guided planner may do otherwise than its policy says, to measure what that is
/// worth: random_tie_breaking (who of two in conflict yields is drawn at each step, `sylph` alone),
/// svo_by_priority, random_svo_per_step, random_svo_per_episode, random_svo_per_partner (see
/// SvoChoice).
const std::vector<std::string>& ablationNames();

/// @param policy    for planners that need one, ignored by the others
/// @param ablation  one of ablationNames() or empty; the planner's name then is `name/ablation`
/// @throws std::invalid_argument naming the allowed names, or that there is no policy
std::unique_ptr<Planner> makePlanner(const std::string& name,
                                     std::shared_ptr<const Policy> policy = nullptr,
                                     const std::string& ablation = "");

}  // namespace sylph
