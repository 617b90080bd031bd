#include "sylph_core/mission/checked_plan.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/text/format.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph {
namespace {

struct TimedResult {
  PlanningResult result;
  double planning_s;
};

/// A search asks for the time once a step, and only in steps that it always takes: in one thread
/// it is told the same each time it runs.
Clock stepClock(double steps_per_s) {
  return [steps_per_s, steps = std::make_shared<long>(0)] {
    return static_cast<double>((*steps)++) / steps_per_s;
  };
}

TimedResult runPlanner(const Mission& mission, const Instance& instance) {
  PlanningLimits limits;
  limits.time_limit_s = mission.time_limit_s;
  limits.first_solution_only = mission.first_solution_only;
  if (mission.search_steps_per_s > 0.0) {
    limits.clock = stepClock(mission.search_steps_per_s);
  }
  Rng rng(mission.seed);
  const double begin_s = limits.clock();
  try {
    const auto planner = makePlanner(mission.planner, mission.policy);
    PlanningResult result = planner->plan(instance, limits, rng);
    return {std::move(result), limits.clock() - begin_s};
  } catch (const std::exception& error) {
    throw MissionFailure(MissionOutcome::NoPlan,
                         "planner " + mission.planner + " failed: " + error.what());
  }
}

/// One social state per joint action; unknown where the planner gives none.
std::vector<SocialState> completeSocial(std::vector<SocialState> social, std::size_t steps,
                                        std::size_t agents) {
  SocialState unknown;
  for (std::size_t agent = 0; agent < agents; ++agent) {
    unknown.partners.push_back(static_cast<AgentId>(agent));
    unknown.svo_deg.push_back(std::numeric_limits<float>::quiet_NaN());
  }
  for (SocialState& state : social) {
    if (state.partners.size() != agents || state.svo_deg.size() != agents) {
      state = unknown;
    }
  }
  social.resize(steps, unknown);
  return social;
}

CheckedPlan check(const Mission& mission, const Instance& instance, TimedResult timed) {
  if (const auto violation = checkPlan(instance, timed.result.plan)) {
    throw MissionFailure(MissionOutcome::NoPlan,
                         "the plan of planner " + mission.planner +
                             " is wrong and was dropped: " + violation->message);
  }
  CheckedPlan checked;
  checked.instance = instance;
  checked.social = completeSocial(std::move(timed.result.social), timed.result.plan.size() - 1,
                                  instance.starts.size());
  checked.plan = std::move(timed.result.plan);
  checked.metrics = computeMetrics(instance, checked.plan);
  // Not computed here: the time for planning is over, and robots may stand and wait.
  const PlanningStatistics& statistics = timed.result.statistics;
  checked.least_sum_of_costs = statistics.proved_sum_of_costs ? statistics.proved_sum_of_costs
                                                              : statistics.sum_of_costs_lower_bound;
  checked.planning_s = timed.planning_s;
  return checked;
}

}  // namespace

std::string ratedCostOf(const CheckedPlan& plan) {
  std::string text = "sum of costs " + std::to_string(plan.metrics.sum_of_costs);
  if (plan.least_sum_of_costs) {
    const auto cost = static_cast<double>(plan.metrics.sum_of_costs);
    const auto least = static_cast<double>(*plan.least_sum_of_costs);
    text += cost <= least ? ", the least there is"
                          : format(", at most %.0f %% above the least",
                                   std::ceil(100.0 * (cost / std::max(least, 1.0) - 1.0)));
  }
  return text;
}

std::string certificateOf(const CheckedPlan& plan) {
  const std::size_t robots = plan.instance.starts.size();
  return std::to_string(plan.metrics.steps) + " steps, " + ratedCostOf(plan) +
         "; checked: no two robots in one cell, none swap or rotate, " +
         (robots == 1 ? "it ends on its goal"
                      : "all " + std::to_string(robots) + " end on their goals");
}

MissionPlan toMissionPlan(const CheckedPlan& plan, const std::vector<std::string>& robots,
                          const std::string& planner) {
  MissionPlan mission_plan;
  mission_plan.planner = planner;
  mission_plan.planning_s = plan.planning_s;
  mission_plan.robots = robots;
  mission_plan.goals = plan.instance.goals;
  mission_plan.plan = plan.plan;
  mission_plan.social = plan.social;
  return mission_plan;
}

Instance toInstance(const Mission& mission, const Configuration& starts,
                    const CellOwners& bystanders) {
  const GoalJudge judge(mission.grid, bystanders);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const auto bystander = bystanders.find(starts[i]);
    if (bystander != bystanders.end()) {
      throw MissionFailure(MissionOutcome::NoPose, mission.robots[i] + " in cell " +
                                                       toString(starts[i]) + " is too near to " +
                                                       bystander->second +
                                                       ", which has no part in the mission");
    }
    const std::string refusal = judge.refusal(mission.robots[i], mission.goals[i], starts[i]);
    if (!refusal.empty()) {
      throw MissionFailure(MissionOutcome::BadRequest, refusal);
    }
  }
  return {judge.grid(), starts, mission.goals, MotionModel{false}};
}

MissionStart startOf(const Mission& mission, const std::vector<RobotSpec>& lab,
                     const RobotPoses& poses, bool ignores_unseen_robots,
                     double bystander_distance_m) {
  const Configuration starts = startCells(mission, poses);
  std::vector<std::string> unseen = unseenBystanders(mission, lab, poses);
  if (!unseen.empty() && !ignores_unseen_robots) {
    throw MissionFailure(
        MissionOutcome::NoPose,
        join(unseen, "\n") +
            "\nwith ignore_unseen_robots the planner goes on without after pose_wait_s");
  }
  const CellOwners bystanders = cellsOfBystanders(mission, lab, poses, bystander_distance_m);
  return {toInstance(mission, starts, bystanders), bystanders, std::move(unseen)};
}

CheckedPlan stillFitting(const Mission& mission, const Instance& instance,
                         const CheckedPlan& plan) {
  const auto refuse = [](const std::string& reason) {
    throw MissionFailure(MissionOutcome::BadRequest, reason + ": plan again");
  };
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    if (instance.starts[i] != plan.instance.starts[i]) {
      refuse(mission.robots[i] + " stands in " + toString(instance.starts[i]) +
             ", where the plan that was shown begins in " + toString(plan.instance.starts[i]));
    }
  }
  if (const auto violation = checkPlan(instance, plan.plan)) {
    refuse("the plan that was shown does not fit any more, " + violation->message);
  }
  CheckedPlan fitting = plan;
  fitting.instance = instance;
  return fitting;
}

CheckedPlan planMission(const Mission& mission, const Instance& instance) {
  TimedResult timed = runPlanner(mission, instance);
  if (timed.result.outcome != Outcome::Solved) {
    throw MissionFailure(MissionOutcome::NoPlan, "planner " + mission.planner + " found no plan: " +
                                                     toString(timed.result.outcome));
  }
  return check(mission, instance, std::move(timed));
}

CheckedPlan planAsFarAsPossible(const Mission& mission, const Instance& instance) {
  TimedResult timed = runPlanner(mission, instance);
  if (timed.result.outcome == Outcome::Solved) {
    return check(mission, instance, std::move(timed));
  }
  if (timed.result.plan.empty()) {
    timed.result.plan = {instance.starts};
  }
  Instance shortened = instance;
  shortened.goals = timed.result.plan.back();
  return check(mission, shortened, std::move(timed));
}

}  // namespace sylph
