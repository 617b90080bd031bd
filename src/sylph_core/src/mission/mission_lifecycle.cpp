#include "sylph_core/mission/mission_lifecycle.hpp"

#include <algorithm>
#include <exception>

#include "sylph_core/mission/replanning.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

using Level = mission_command::Say::Level;

using PlanningFunction = CheckedPlan (*)(const Mission&, const Instance&);

mission_command::Plan planCommand(PlanningFunction plan, const Mission& mission,
                                  const Instance& instance) {
  return {[plan, mission, instance] { return outcomeOf([&] { return plan(mission, instance); }); }};
}

}  // namespace

PlanningOutcome outcomeOf(const std::function<CheckedPlan()>& plan) {
  try {
    return plan();
  } catch (const MissionFailure& failure) {
    return failure;
  } catch (const std::exception& error) {
    return MissionFailure(MissionOutcome::NoPlan, error.what());
  }
}

void MissionLifecycle::supersede(double now_s) {
  if (stage_ != Stage::Idle) {
    pauseIfUnderWay();
    MissionResult result;
    result.outcome = MissionOutcome::Preempted;
    result.message = "another mission has taken its place";
    finish(result, now_s);
  }
}

void MissionLifecycle::begin(Mission mission, double now_s, std::optional<CheckedPlan> shown) {
  mission_ = std::move(mission);
  shown_plan_ = std::move(shown);
  totals_ = {};
  totals_.robots = static_cast<std::uint32_t>(mission_.robots.size());
  replaces_plan_id_ = 0;
  given_up_.clear();
  bystanders_.clear();
  enter(Stage::Starting, now_s);
}

void MissionLifecycle::cancel(double now_s) {
  if (stage_ != Stage::Idle) {
    pauseIfUnderWay();
    enter(Stage::Pausing, now_s);
  }
}

void MissionLifecycle::fail(const MissionFailure& failure, double now_s) {
  MissionResult result;
  result.outcome = failure.outcome();
  result.message = failure.what();
  if (stage_ == Stage::Idle) {
    totals_ = {};
  } else if (state_) {
    result.arrived = robotsArrived(mission_, *state_);
  }
  finish(result, now_s);
}

void MissionLifecycle::onAdgState(AdgState state, double now_s) {
  state_ = std::move(state);
  state_received_s_ = now_s;
}

void MissionLifecycle::onPlanned(PlanningOutcome outcome, double now_s) {
  is_planning_ = false;
  if (stage_ != Stage::Planning) {
    return;  // the mission was left meanwhile
  }
  if (const auto* failure = std::get_if<MissionFailure>(&outcome)) {
    fail(*failure, now_s);
  } else {
    send(std::get<CheckedPlan>(outcome), now_s);
  }
}

void MissionLifecycle::tick(const RobotPoses& poses, double now_s) {
  const bool needs_central =
      stage_ == Stage::Starting || stage_ == Stage::Sending || stage_ == Stage::Executing;
  if (needs_central && hasBeenSilent(now_s)) {
    fail({MissionOutcome::PlanRefused, "the central node is silent: no message on " + state_topic_},
         now_s);
    return;
  }
  try {
    switch (stage_) {
      case Stage::Starting:
        tickStarting(poses, now_s);
        break;
      case Stage::Sending:
        tickSending(now_s);
        break;
      case Stage::Executing:
        tickExecuting(now_s);
        break;
      case Stage::Pausing:
        tickPausing(now_s);
        break;
      default:
        break;
    }
  } catch (const MissionFailure& failure) {
    fail(failure, now_s);
  }
}

void MissionLifecycle::tickStarting(const RobotPoses& poses, double now_s) {
  // What the central node said before the mission may be out of date.
  if (!state_ || state_received_s_ < stage_since_s_ || is_planning_) {
    return;
  }
  if (isExecutionOf(mission_, *state_)) {
    plan_id_ = state_->plan_id;
    say(Level::Info,
        "plan " + std::to_string(plan_id_) + " of this mission is under way: going on with it");
    follow(now_s);
    return;
  }
  const double waited_s = now_s - stage_since_s_;
  if (isBusy(*state_) && !allHold(*state_)) {
    if (!has_paused_ || waited_s >= limits_.hold_wait_s) {
      fail({MissionOutcome::BadRequest,
            "plan " + std::to_string(state_->plan_id) +
                " of another mission is being carried out: cancel that one first"},
           now_s);
    }
    return;
  }
  try {
    startPlanning(poses, now_s);
  } catch (const MissionFailure& failure) {
    waits_for_ = failure.what();
    if (failure.outcome() != MissionOutcome::NoPose || waited_s > limits_.pose_wait_s) {
      fail(failure, now_s);
    }
  }
}

void MissionLifecycle::tickSending(double now_s) {
  if (!state_) {
    return;
  }
  // The central node may have the plan, another one, or have missed it: topics give no answer.
  const bool is_known = state_->plan_id == plan_id_;
  if (hasLostMore()) {
    startReplanning(now_s);
  } else if (is_known && state_->phase == ExecutionPhase::Refused) {
    fail({MissionOutcome::PlanRefused, "the central node refused the plan: " + state_->message},
         now_s);
  } else if (is_known && state_->phase != ExecutionPhase::Pending) {
    follow(now_s);
  } else if (!is_known && now_s - stage_since_s_ > limits_.central_wait_s) {
    fail({MissionOutcome::PlanRefused, "the central node does not take plan " +
                                           std::to_string(plan_id_) + ": it has plan " +
                                           std::to_string(state_->plan_id)},
         now_s);
  } else if (now_s - sent_s_ >= limits_.resend_period_s) {
    sendAgain(now_s);
  }
}

bool MissionLifecycle::hasLostMore() const {
  // The central node then drops the plan as it comes: it leads a robot that is gone.
  const bool waits_at_cut = replaces_plan_id_ != 0 && state_->plan_id == replaces_plan_id_ &&
                            state_->phase == ExecutionPhase::AtCut;
  return waits_at_cut &&
         std::any_of(state_->robots.begin(), state_->robots.end(), [this](const auto& robot) {
           const auto& planned = planned_robots_;
           return robot.condition == RobotCondition::Lost &&
                  std::find(planned.begin(), planned.end(), robot.robot) != planned.end();
         });
}

void MissionLifecycle::tickExecuting(double now_s) {
  if (state_->plan_id > plan_id_) {
    fail({MissionOutcome::PlanRefused, "plan " + std::to_string(plan_id_) +
                                           " was replaced by plan " +
                                           std::to_string(state_->plan_id) + " of another mission"},
         now_s);
  } else if (state_->plan_id < plan_id_) {
    // It began with an empty log; what this node has not sent itself it cannot send again.
    if (has_published_) {
      say(Level::Warning,
          "the central node has lost plan " + std::to_string(plan_id_) + ": sending it again");
      sendAgain(now_s);
      enter(Stage::Sending, now_s);
    }
  } else if (state_->phase == ExecutionPhase::Finished) {
    finish(finishedResult(mission_, *state_, given_up_), now_s);
  } else if (state_->phase == ExecutionPhase::Refused) {
    fail({MissionOutcome::PlanRefused, "the central node has ended the plan: " + state_->message},
         now_s);
  } else if (state_->phase == ExecutionPhase::AtCut) {
    startReplanning(now_s);
  }
}

void MissionLifecycle::tickPausing(double now_s) {
  const bool is_too_late = now_s - stage_since_s_ > limits_.hold_wait_s;
  if (has_paused_ && !is_too_late && !(state_ && allHold(*state_))) {
    return;
  }
  MissionResult result;
  if (state_) {
    result.arrived = robotsArrived(mission_, *state_);
    result.execution_s = has_paused_ ? state_->elapsed_s : 0.0;
  }
  result.outcome = MissionOutcome::Preempted;
  result.message = !has_paused_  ? "cancelled before a robot moved"
                   : is_too_late ? "cancelled; the central node does not say that robots hold"
                                 : "cancelled: the robots hold at their next cells";
  finish(result, now_s);
}

void MissionLifecycle::startPlanning(const RobotPoses& poses, double now_s) {
  // A robot that is seen a moment later must not be taken for one that is not there.
  const bool ignores_unseen_robots =
      limits_.ignores_unseen_robots && now_s - stage_since_s_ > limits_.pose_wait_s;
  MissionStart start =
      startOf(mission_, lab_, poses, ignores_unseen_robots, limits_.bystander_distance_m);
  for (const std::string& line : start.unseen) {
    say(Level::Warning, line + "; it is ignored");
  }
  bystanders_ = std::move(start.bystanders);
  planned_robots_ = mission_.robots;
  if (shown_plan_) {
    send(stillFitting(mission_, start.instance, *shown_plan_), now_s);
  } else {
    plan(planCommand(planMission, mission_, start.instance), now_s);
  }
}

void MissionLifecycle::startReplanning(double now_s) {
  Mission limited = mission_;
  // All robots stand and wait for it.
  limited.time_limit_s = std::min(limited.time_limit_s, limits_.replanning_time_limit_s);
  for (const auto& [cell, robot] : bystanders_) {
    limited.grid.setObstacle(cell);
  }
  const RestOfMission rest = restOfMission(limited, *state_);
  for (const std::string& line : rest.given_up) {
    say(Level::Warning, line);
  }
  given_up_ = rest.given_up;
  planned_robots_ = rest.robots;
  replaces_plan_id_ = state_->plan_id;
  ++totals_.replans;
  plan(planCommand(planAsFarAsPossible, limited, rest.instance), now_s);
}

void MissionLifecycle::plan(mission_command::Plan command, double now_s) {
  commands_.emplace_back(std::move(command));
  is_planning_ = true;
  enter(Stage::Planning, now_s);
}

void MissionLifecycle::send(const CheckedPlan& plan, double now_s) {
  totals_.planning_s += plan.planning_s;
  totals_.plan_steps = static_cast<std::uint32_t>(plan.metrics.steps);
  totals_.sum_of_costs = static_cast<std::uint32_t>(plan.metrics.sum_of_costs);
  // The central node and the robots remember plans even when this program was started again.
  const std::uint32_t known = state_ ? std::max(state_->plan_id, state_->last_plan_id) : 0;
  plan_id_ = std::max(plan_id_, known) + 1;
  say(Level::Info, "plan " + std::to_string(plan_id_) + " by " + mission_.planner + ": " +
                       std::to_string(plan.metrics.steps) + " steps, " + ratedCostOf(plan) +
                       format(", planned in %.2f s", plan.planning_s));
  MissionPlan mission_plan = toMissionPlan(plan, planned_robots_, mission_.planner);
  mission_plan.plan_id = plan_id_;
  mission_plan.replaces_plan_id = replaces_plan_id_;
  commands_.emplace_back(mission_command::Publish{std::move(mission_plan)});
  has_published_ = true;
  sent_s_ = now_s;
  enter(Stage::Sending, now_s);
}

void MissionLifecycle::sendAgain(double now_s) {
  commands_.emplace_back(mission_command::PublishAgain{});
  sent_s_ = now_s;
}

void MissionLifecycle::follow(double now_s) {
  // Only its own pause: an operator may have a reason to keep the robots where they are.
  has_paused_ = false;
  if (std::exchange(lifts_pause_, false) && state_->mode == ExecutionMode::Pause) {
    commands_.emplace_back(mission_command::Resume{});
  }
  enter(Stage::Executing, now_s);
}

void MissionLifecycle::pauseIfUnderWay() {
  const bool is_under_way = stage_ == Stage::Sending || stage_ == Stage::Executing ||
                            (stage_ == Stage::Planning && replaces_plan_id_ != 0);
  if (is_under_way) {
    has_paused_ = true;
    lifts_pause_ = lifts_pause_ || !state_ || state_->mode == ExecutionMode::Run;
    commands_.emplace_back(mission_command::Pause{});
  }
}

void MissionLifecycle::finish(MissionResult result, double now_s) {
  result.robots = totals_.robots;
  result.planning_s = totals_.planning_s;
  result.plan_steps = totals_.plan_steps;
  result.sum_of_costs = totals_.sum_of_costs;
  result.replans = totals_.replans;
  last_outcome_ = result.message;
  // Otherwise a central node that is started later would find the latched plan and carry it out.
  if (std::exchange(has_published_, false)) {
    commands_.emplace_back(mission_command::Withdraw{});
  }
  const bool is_failure =
      result.outcome != MissionOutcome::Success && result.outcome != MissionOutcome::Preempted;
  say(is_failure ? Level::Error : Level::Info, "mission ends: " + result.message);
  commands_.emplace_back(mission_command::End{std::move(result)});
  enter(Stage::Idle, now_s);
}

void MissionLifecycle::enter(Stage stage, double now_s) {
  waits_for_.clear();
  stage_ = stage;
  stage_since_s_ = now_s;
}

void MissionLifecycle::say(Level level, const std::string& text) {
  commands_.emplace_back(mission_command::Say{level, text});
}

bool MissionLifecycle::hasBeenSilent(double now_s) const {
  const double since_s = state_ ? std::max(stage_since_s_, state_received_s_) : stage_since_s_;
  return now_s - since_s > limits_.central_wait_s;
}

MissionProgress MissionLifecycle::progress() const {
  const bool has_plan = state_ && (stage_ == Stage::Executing || stage_ == Stage::Pausing);
  std::string phase = toString(stage_);
  if (stage_ == Stage::Planning && replaces_plan_id_ != 0) {
    phase = "replanning";
  } else if (stage_ == Stage::Executing && state_->phase == ExecutionPhase::Cutting) {
    phase = "cutting";
  }
  MissionProgress progress = progressOf(phase, mission_, has_plan ? *state_ : AdgState());
  if (stage_ == Stage::Starting && !waits_for_.empty()) {
    progress.waiting.push_back(waits_for_);
  } else if (stage_ == Stage::Sending && state_ && state_->phase == ExecutionPhase::Pending &&
             !state_->message.empty()) {
    progress.waiting.push_back(state_->message);
  }
  return progress;
}

std::string toString(MissionLifecycle::Stage stage) {
  static constexpr const char* kNames[] = {"idle",    "starting",  "planning",
                                           "sending", "executing", "pausing"};
  return kNames[static_cast<int>(stage)];
}

}  // namespace sylph
