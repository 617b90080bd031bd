#include "sylph_core/adg/run_record.hpp"

#include <algorithm>
#include <cmath>

#include "sylph_core/adg/explanation.hpp"
#include "sylph_core/adg/schedule.hpp"
#include "sylph_core/mapf/metrics.hpp"

namespace sylph {

void RunRecord::add(const StampedEvent& entry) {
  const auto& what = entry.event.what;
  if (const auto* started = std::get_if<event::Started>(&what)) {
    if (started->plan->replaces_plan_id == 0) {
      // A new mission in the same run folder: figures of the one before are not its own, save what
      // holds for the lab as a whole.
      RunRecord begun;
      begun.mode_ = mode_;
      begun.min_separation_m_ = min_separation_m_;
      begun.collisions_ = collisions_;
      *this = begun;
    } else {
      ++replans_;
    }
    planning_s_ += started->plan->planning_s;
  } else if (std::holds_alternative<event::Released>(what)) {
    first_released_s_ = first_released_s_.value_or(entry.stamp_s);
    // So that a mission that is broken off before any task is done took no time, not a negative
    // one.
    last_done_s_ = std::max(last_done_s_, *first_released_s_);
  } else if (std::holds_alternative<event::Done>(what)) {
    last_done_s_ = entry.stamp_s;
  } else if (const auto* mode = std::get_if<event::Mode>(&what)) {
    // The operator and the separation monitor may both say stop: one stop.
    const bool is_stop = mode->mode == ExecutionMode::Stop && mode->mode != mode_;
    stops_ += is_stop ? 1 : 0;
    mode_ = mode->mode;
  }
}

void RunRecord::addTrackingError(double error_m) {
  if (std::isfinite(error_m)) {
    max_tracking_error_m_ = std::max(max_tracking_error_m_, error_m);
  }
}

double RunRecord::elapsed(double stamp_s, bool is_over) const {
  if (!first_released_s_) {
    return 0.0;
  }
  return (is_over ? last_done_s_ : stamp_s) - *first_released_s_;
}

RunResult RunRecord::result(const Execution& execution, double cell_s) const {
  RunResult result;
  result.robots = static_cast<int>(execution.missionGoals().size());
  result.planning_s = planning_s_;
  result.execution_s = elapsed(0.0, true);
  result.min_separation_m = min_separation_m_;
  result.max_tracking_error_m = max_tracking_error_m_;
  result.replans = replans_;
  result.stops = stops_;
  result.collisions = collisions_;
  if (const MissionPlan* plan = execution.plan()) {
    result.arrived = arrivedRobots(execution);
    result.planner = plan->planner;
    result.plan_steps = plan->steps();
    Instance instance;
    instance.starts = plan->plan.front();
    instance.goals = plan->goals;
    result.sum_of_costs = computeMetrics(instance, plan->plan).sum_of_costs;
    result.critical_path_cells = computeSchedule(*execution.graph()).critical_path;
    result.ideal_execution_s = result.critical_path_cells * cell_s;
  }
  const bool is_finished = execution.phase() == ExecutionPhase::Finished;
  // Collisions are known in simulation alone.
  result.success = is_finished && result.robots > 0 && result.arrived == result.robots &&
                   collisions_.value_or(0) == 0;
  result.message =
      is_finished ? std::to_string(result.arrived) + " of " + std::to_string(result.robots) +
                        " robots have arrived"
                  : toString(execution.phase()) +
                        (execution.message().empty() ? std::string() : ": " + execution.message());
  return result;
}

}  // namespace sylph
