#include "mission_planner.hpp"

#include <algorithm>
#include <exception>

#include "sylph_core/grid/rng.hpp"

namespace sylph_rehearsal {
namespace {

constexpr double kPeriod_s = 0.1;
constexpr double kResendPeriod_s = 1.0;

/// What a planner may spend: steps of its search and never wall time, so that the plan depends on
/// the seed alone.
sylph::PlanningLimits deterministicLimits() {
  sylph::PlanningLimits limits;
  limits.first_solution_only = true;
  limits.social_states = false;
  limits.clock = [] { return 0.0; };
  return limits;
}

}  // namespace

MissionPlanner::MissionPlanner(const sylph::Experiment& experiment,
                               std::unique_ptr<sylph::Planner> planner, double planning_s,
                               EventQueue& queue, PlanPort send)
    : experiment_(&experiment),
      frame_(sylph::cellFrameOf(experiment)),
      planner_(std::move(planner)),
      planning_s_(planning_s),
      queue_(&queue),
      send_(std::move(send)),
      poses_(experiment.robots.size()) {}

void MissionPlanner::start() {
  if (is_up_) {
    return;
  }
  is_up_ = true;
  stage_ = Stage::Starting;
  state_.reset();
  std::fill(poses_.begin(), poses_.end(), std::nullopt);
  plan_ = {};
  tick(++life_);
}

void MissionPlanner::crash() {
  is_up_ = false;
  ++life_;
}

void MissionPlanner::sendAgain() {
  if (is_up_ && plan_.plan_id != 0 && stage_ != Stage::Planning) {
    send();
  }
}

void MissionPlanner::onState(const sylph::AdgState& state) {
  if (is_up_) {
    state_ = state;
  }
}

void MissionPlanner::onPose(std::size_t robot, const sylph::Pose2d& pose) {
  if (is_up_) {
    poses_[robot] = pose;
  }
}

void MissionPlanner::tick(int life) {
  if (life != life_ || stage_ == Stage::Over) {
    return;
  }
  if (state_) {
    act();
  }
  queue_->after(kPeriod_s, [this, life] { tick(life); });
}

void MissionPlanner::act() {
  const bool is_of_plan = state_->plan_id == plan_.plan_id;
  switch (stage_) {
    case Stage::Starting:
      if (isUnderWay()) {
        plan_.plan_id = state_->plan_id;
        stage_ = Stage::Executing;
      } else if (std::all_of(poses_.begin(), poses_.end(),
                             [](const auto& pose) { return pose.has_value(); })) {
        plan();
      }
      return;
    case Stage::Sending:
      if (is_of_plan && state_->phase == sylph::ExecutionPhase::Refused) {
        failure_ = state_->message;
        stage_ = Stage::Over;
      } else if (is_of_plan && state_->phase != sylph::ExecutionPhase::Pending) {
        stage_ = Stage::Executing;
      } else if (queue_->now() - sent_s_ >= kResendPeriod_s) {
        send();
      }
      return;
    case Stage::Executing:
      if (is_of_plan && state_->phase == sylph::ExecutionPhase::Refused) {
        failure_ = state_->message;
        stage_ = Stage::Over;
      } else if (state_->plan_id < plan_.plan_id && !plan_.plan.empty()) {
        send();  // the central node has lost it
        stage_ = Stage::Sending;
      }
      return;
    case Stage::Planning:
    case Stage::Over:
      return;
  }
}

bool MissionPlanner::isUnderWay() const {
  using Phase = sylph::ExecutionPhase;
  if (state_->plan_id == 0 || state_->phase == Phase::Idle || state_->phase == Phase::Refused ||
      state_->phase == Phase::Pending) {
    return false;
  }
  for (std::size_t robot = 0; robot < state_->robots.size(); ++robot) {
    if (state_->robots[robot].goal != experiment_->robots[robot].goal) {
      return false;
    }
  }
  return true;
}

void MissionPlanner::plan() {
  sylph::Instance instance = toInstance(*experiment_);
  for (std::size_t robot = 0; robot < poses_.size(); ++robot) {
    instance.starts[robot] = frame_.toCell(sylph::position(*poses_[robot]));
  }
  sylph::Rng rng(experiment_->seed);
  try {
    sylph::requireValid(instance);
    const sylph::PlanningResult result = planner_->plan(instance, deterministicLimits(), rng);
    if (result.outcome != sylph::Outcome::Solved) {
      throw std::runtime_error("planner " + planner_->name() +
                               " found no plan: " + toString(result.outcome));
    }
    plan_.plan = result.plan;
  } catch (const std::exception& error) {
    failure_ = error.what();
    stage_ = Stage::Over;
    return;
  }
  plan_.plan_id = std::max(state_->plan_id, state_->last_plan_id) + 1;
  plan_.planner = planner_->name();
  plan_.planning_s = planning_s_;
  plan_.goals = instance.goals;
  plan_.robots = namesOf(*experiment_);
  plan_.social.resize(plan_.steps());
  stage_ = Stage::Planning;
  queue_->after(planning_s_, [this, life = life_] {
    if (life == life_) {
      stage_ = Stage::Sending;
      send();
    }
  });
}

void MissionPlanner::send() {
  sent_s_ = queue_->now();
  send_(plan_);
}

}  // namespace sylph_rehearsal
