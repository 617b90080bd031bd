#include "sylph_adg_central/run_record.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "sylph_core/adg/explanation.hpp"
#include "sylph_core/adg/schedule.hpp"
#include "sylph_core/mapf/metrics.hpp"

namespace sylph_adg_central {

void writeResult(const RunResult& result, const std::string& path) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  const auto put = [&](const char* key, const auto& value) {
    yaml << YAML::Key << key << YAML::Value << value;
  };
  put("success", result.success);
  put("message", result.message);
  put("planner", result.planner);
  put("robots", result.robots);
  put("arrived", result.arrived);
  put("plan_steps", result.plan_steps);
  put("sum_of_costs", result.sum_of_costs);
  put("planning_s", result.planning_s);
  put("execution_s", result.execution_s);
  put("critical_path_cells", result.critical_path_cells);
  put("ideal_execution_s", result.ideal_execution_s);
  if (result.ideal_execution_s > 0.0) {
    put("execution_ratio", result.execution_s / result.ideal_execution_s);
  } else {
    put("execution_ratio", YAML::Null);
  }
  if (result.min_separation_m) {
    put("min_separation_m", *result.min_separation_m);
  } else {
    put("min_separation_m", YAML::Null);
  }
  put("max_tracking_error_m", result.max_tracking_error_m);
  put("replans", result.replans);
  put("stops", result.stops);
  if (result.collisions) {
    put("collisions", *result.collisions);
  }
  yaml << YAML::EndMap;
  std::ofstream file(path);
  file << yaml.c_str() << "\n";
  if (!file.flush()) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

void RunRecord::add(const sylph::StampedEvent& entry) {
  const auto& what = entry.event.what;
  if (const auto* started = std::get_if<sylph::event::Started>(&what)) {
    if (started->plan->replaces_plan_id == 0) {
      RunRecord begun;
      begun.mode_ = mode_;
      begun.min_separation_m_ = min_separation_m_;
      begun.collisions_ = collisions_;
      *this = begun;
    } else {
      ++replans_;
    }
    planning_s_ += started->plan->planning_s;
  } else if (std::holds_alternative<sylph::event::Released>(what)) {
    first_released_s_ = first_released_s_.value_or(entry.stamp_s);
    last_done_s_ = std::max(last_done_s_, *first_released_s_);
  } else if (std::holds_alternative<sylph::event::Done>(what)) {
    last_done_s_ = entry.stamp_s;
  } else if (const auto* mode = std::get_if<sylph::event::Mode>(&what)) {
    const bool is_stop = mode->mode == sylph::ExecutionMode::Stop && mode->mode != mode_;
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

RunResult RunRecord::result(const sylph::Execution& execution, double cell_s) const {
  RunResult result;
  result.robots = static_cast<int>(execution.missionGoals().size());
  result.planning_s = planning_s_;
  result.execution_s = elapsed(0.0, true);
  result.min_separation_m = min_separation_m_;
  result.max_tracking_error_m = max_tracking_error_m_;
  result.replans = replans_;
  result.stops = stops_;
  result.collisions = collisions_;
  if (const sylph::MissionPlan* plan = execution.plan()) {
    result.arrived = sylph::arrivedRobots(execution);
    result.planner = plan->planner;
    result.plan_steps = plan->steps();
    sylph::Instance instance;
    instance.starts = plan->plan.front();
    instance.goals = plan->goals;
    result.sum_of_costs = sylph::computeMetrics(instance, plan->plan).sum_of_costs;
    result.critical_path_cells = sylph::computeSchedule(*execution.graph()).critical_path;
    result.ideal_execution_s = result.critical_path_cells * cell_s;
  }
  const bool is_finished = execution.phase() == sylph::ExecutionPhase::Finished;
  result.success = is_finished && result.robots > 0 && result.arrived == result.robots &&
                   collisions_.value_or(0) == 0;
  result.message =
      is_finished ? std::to_string(result.arrived) + " of " + std::to_string(result.robots) +
                        " robots have arrived"
                  : toString(execution.phase()) +
                        (execution.message().empty() ? std::string() : ": " + execution.message());
  return result;
}

}  // namespace sylph_adg_central
