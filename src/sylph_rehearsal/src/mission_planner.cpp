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
  tick();
}

void MissionPlanner::onState(const sylph::AdgState& state) {
  state_ = state;
}

void MissionPlanner::onPose(std::size_t robot, const sylph::Pose2d& pose) {
  poses_[robot] = pose;
}

void MissionPlanner::tick() {
  if (stage_ == Stage::Starting && state_ &&
      std::all_of(poses_.begin(), poses_.end(),
                  [](const auto& pose) { return pose.has_value(); })) {
    plan();
  } else if (stage_ == Stage::Sending && state_->plan_id == plan_.plan_id &&
             state_->phase != sylph::ExecutionPhase::Pending) {
    stage_ = Stage::Executing;
  } else if (stage_ == Stage::Sending && queue_->now() - sent_s_ >= kResendPeriod_s) {
    send();
  } else if (stage_ == Stage::Executing && state_->plan_id < plan_.plan_id) {
    send();  // the central node has lost it
    stage_ = Stage::Sending;
  }
  if (stage_ != Stage::Over) {
    queue_->after(kPeriod_s, [this] { tick(); });
  }
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
  for (const sylph::RobotSpec& robot : experiment_->robots) {
    plan_.robots.push_back(robot.name);
  }
  plan_.social.resize(plan_.steps());
  stage_ = Stage::Planning;
  queue_->after(planning_s_, [this] {
    stage_ = Stage::Sending;
    send();
  });
}

void MissionPlanner::send() {
  sent_s_ = queue_->now();
  send_(plan_);
}

}  // namespace sylph_rehearsal
