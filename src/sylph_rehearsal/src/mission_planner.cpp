#include "mission_planner.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <utility>
#include <variant>

#include "sylph_core/planners/planner.hpp"

namespace sylph_rehearsal {
namespace {

/// As the planner's node has them by default [s].
constexpr double kTickPeriod_s = 0.05;
constexpr double kPoseTimeout_s = 0.5;
/// A search that has found nothing after so many steps has failed: a mission ends in any case.
constexpr double kLeastSearchSteps = 5000.0;
/// Before it, each agent's distances spread by a cell a step, seldom farther than this many times
/// rows and columns.
constexpr double kLongestWay = 4.0;

double searchSteps(const sylph::Experiment& experiment) {
  const int sides = experiment.grid.rows() + experiment.grid.cols();
  return std::max(kLeastSearchSteps,
                  kLongestWay * sides * static_cast<double>(experiment.robots.size()));
}

sylph::Mission rehearsedMission(const sylph::Experiment& experiment,
                                std::shared_ptr<const sylph::Policy> policy) {
  // Throws if there is no such planner, or it lacks a policy.
  sylph::makePlanner(experiment.planning.planner, policy);
  sylph::Mission mission = sylph::toMission(experiment, std::move(policy));
  // Never by the wall: the plan depends on the seed alone.
  mission.search_steps_per_s = searchSteps(experiment) / mission.time_limit_s;
  mission.first_solution_only = true;
  return mission;
}

}  // namespace

MissionPlanner::MissionPlanner(const sylph::Experiment& experiment,
                               std::shared_ptr<const sylph::Policy> policy, double planning_s,
                               EventQueue& queue, Ports ports)
    : experiment_(&experiment),
      mission_(rehearsedMission(experiment, std::move(policy))),
      planning_s_(planning_s),
      queue_(&queue),
      ports_(std::move(ports)),
      poses_(experiment.robots.size()) {}

void MissionPlanner::start() {
  if (lifecycle_) {
    return;
  }
  lifecycle_.emplace(experiment_->robots, sylph::MissionLimits(), "adg_state");
  std::fill(poses_.begin(), poses_.end(), std::nullopt);
  lifecycle_->begin(mission_, queue_->now());
  tick(++life_);
}

void MissionPlanner::crash() {
  lifecycle_.reset();
  plan_.reset();
  ++life_;
}

void MissionPlanner::sendAgain() {
  if (plan_) {
    ports_.plan(*plan_);
  }
}

void MissionPlanner::onState(const sylph::AdgState& state) {
  if (lifecycle_) {
    lifecycle_->onAdgState(state, queue_->now());
  }
}

void MissionPlanner::onPose(std::size_t robot, const sylph::Pose2d& pose) {
  if (lifecycle_) {
    poses_[robot] = {pose, queue_->now()};
  }
}

void MissionPlanner::tick(int life) {
  // Of a node that has crashed in the meantime.
  if (life != life_) {
    return;
  }
  lifecycle_->tick(poses(), queue_->now());
  carryOutCommands();
  queue_->after(kTickPeriod_s, [this, life] { tick(life); });
}

sylph::RobotPoses MissionPlanner::poses() const {
  sylph::RobotPoses poses;
  for (std::size_t robot = 0; robot < poses_.size(); ++robot) {
    if (const auto& seen = poses_[robot]) {
      const bool is_old = queue_->now() - seen->received_s > kPoseTimeout_s;
      poses[mission_.robots[robot]] = {seen->pose, is_old ? "has not come lately" : ""};
    }
  }
  return poses;
}

void MissionPlanner::carryOutCommands() {
  for (const sylph::MissionCommand& command : lifecycle_->takeCommands()) {
    std::visit([this](const auto& kind) { carryOut(kind); }, command);
  }
}

void MissionPlanner::carryOut(const sylph::mission_command::Plan& command) {
  sylph::PlanningOutcome outcome = command.make();
  if (auto* plan = std::get_if<sylph::CheckedPlan>(&outcome)) {
    plan->planning_s = planning_s_;
  }
  queue_->after(planning_s_, [this, outcome, life = life_] {
    if (life == life_) {
      lifecycle_->onPlanned(outcome, queue_->now());
      carryOutCommands();
    }
  });
}

void MissionPlanner::carryOut(const sylph::mission_command::Publish& command) {
  plan_ = command.plan;
  sendAgain();
}

void MissionPlanner::carryOut(const sylph::mission_command::Pause& /*command*/) const {
  ports_.mode(sylph::ExecutionMode::Pause);
}

void MissionPlanner::carryOut(const sylph::mission_command::Resume& /*command*/) const {
  ports_.mode(sylph::ExecutionMode::Run);
}

void MissionPlanner::carryOut(const sylph::mission_command::End& command) {
  if (command.result.outcome != sylph::MissionOutcome::Success) {
    failure_ = command.result.message;
  }
}

}  // namespace sylph_rehearsal
