#include "sylph_planner_node/planner_node.hpp"

#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_planner_node/mission_messages.hpp"
#include "sylph_planner_node/occupancy_grid.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/state_messages.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

/// Limits by the clock that the lifecycle is told; those of the wall pass faster there.
sylph::MissionLimits limitsOf(const Options& options, const sylph::Experiment& lab, double speed) {
  sylph::MissionLimits limits = options.limits;
  limits.pose_wait_s *= speed;
  limits.central_wait_s *= speed;
  limits.bystander_distance_m = bystanderDistance(lab);
  return limits;
}

}  // namespace

PlannerNode::PlannerNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : nh_(nh),
      options_(sylph_ros::readStrictly(private_nh, readOptions)),
      lab_(sylph_ros::loadExperiment(nh)),
      weights_(lab_.planning.weights_path),
      clock_(sylph_ros::SteadyClock::fromParameter(nh)),
      poses_(nh, clock_),
      mode_(nh),
      lifecycle_(lab_.robots, limitsOf(options_, lab_, clock_.speed()),
                 nh_.resolveName(sylph_ros::kAdgStateTopic)),
      map_(toOccupancyGrid(lab_.grid, lab_.cell_size_m, lab_.corner)),
      joint_actions_publisher_(
          clock_.advertise<sylph_msgs::JointActions>(nh_, sylph_ros::kJointActionsTopic, 1, true)),
      map_publisher_(nh_.advertise<nav_msgs::OccupancyGrid>(
          sylph_ros::fleetName(nh_, sylph_ros::kMapTopic), 1, true)),
      adg_state_subscriber_(clock_.subscribe<sylph_msgs::AdgState>(
          nh_, sylph_ros::kAdgStateTopic, 10,
          [this](const sylph_msgs::AdgState& state) { onAdgState(state); })),
      server_(nh_, sylph_ros::kExecuteMissionAction, false),
      plan_server_(nh_, options_, limitsOf(options_, lab_, clock_.speed()), lab_, weights_, clock_),
      diagnostics_(nh_, private_nh) {
  // Weights of no use are refused now rather than with the first mission.
  weights_.of(lab_.planning.planner);
  publishMap();
  diagnostics_.setHardwareID("none");
  diagnostics_.add("planner", this, &PlannerNode::report);
  server_.registerGoalCallback([this] { onGoal(); });
  server_.registerPreemptCallback([this] { onPreempt(); });
  server_.start();
  map_timer_ = clock_.createTimer(nh_, options_.map_period_s, [this] { publishMap(); });
  tick_timer_ = clock_.createTimer(nh_, options_.tick_period_s, [this] { tick(); });
}

void PlannerNode::onGoal() {
  lifecycle_.supersede(clock_.now());
  carryOutCommands();
  const auto goal = server_.acceptNewGoal();
  try {
    sylph::Mission wanted = readMission(*goal, lab_, weights_);
    wanted.search_steps_per_s = options_.search_steps_per_s;
    std::optional<sylph::CheckedPlan> shown;
    if (goal->shown_plan_id != 0) {
      shown = plan_server_.planOf(goal->shown_plan_id, wanted);
    }
    plan_server_.withdraw();
    lifecycle_.begin(std::move(wanted), clock_.now(), std::move(shown));
    const sylph::Mission& mission = lifecycle_.mission();
    map_ = toOccupancyGrid(mission.grid, mission.cell_size_m, mission.corner);
    publishMap();
    poses_.start(namesOf(lab_));
    feedback_sent_s_ = clock_.now();  // before there is anything to tell
    if (server_.isPreemptRequested()) {
      onPreempt();
    }
  } catch (const sylph::MissionFailure& failure) {
    lifecycle_.fail(failure, clock_.now());
  }
  carryOutCommands();
}

void PlannerNode::onPreempt() {
  // A new goal calls this first; onGoal() then ends the old mission itself.
  if (server_.isActive() && !server_.isNewGoalAvailable()) {
    lifecycle_.cancel(clock_.now());
    carryOutCommands();
  }
}

void PlannerNode::onAdgState(const sylph_msgs::AdgState& message) {
  if (auto state = sylph_ros::fromMessage(message)) {
    lifecycle_.onAdgState(std::move(*state), clock_.now());
  } else {
    ROS_WARN_THROTTLE(1.0, "a malformed message on %s is dropped",
                      adg_state_subscriber_.getTopic().c_str());
  }
}

void PlannerNode::tick() {
  diagnostics_.update();
  if (const auto error = mode_.takeError()) {
    ROS_ERROR("%s", error->c_str());
  }
  const double now_s = clock_.now();
  plan_server_.tick(lifecycle_.stage() != sylph::MissionLifecycle::Stage::Idle);
  if (planning_.valid() &&
      planning_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    lifecycle_.onPlanned(planning_.get(), now_s);
  }
  lifecycle_.tick(poses_.judged(options_.pose_timeout_s), now_s);
  carryOutCommands();
  if (lifecycle_.stage() != sylph::MissionLifecycle::Stage::Starting) {
    poses_.stop();
  }
  publishFeedback();
}

void PlannerNode::publishMap() {
  map_.header.stamp = clock_.stamp();
  map_.info.map_load_time = map_.header.stamp;
  map_publisher_.publish(map_);
}

void PlannerNode::publishFeedback() {
  const double now_s = clock_.now();
  if (lifecycle_.stage() != sylph::MissionLifecycle::Stage::Idle &&
      now_s - feedback_sent_s_ >= options_.feedback_period_s) {
    feedback_sent_s_ = now_s;
    server_.publishFeedback(toMessage(lifecycle_.progress()));
  }
}

void PlannerNode::carryOutCommands() {
  // A command that fails gives more of them.
  for (auto commands = lifecycle_.takeCommands(); !commands.empty();
       commands = lifecycle_.takeCommands()) {
    for (const sylph::MissionCommand& command : commands) {
      std::visit([this](const auto& kind) { this->carryOut(kind); }, command);
    }
  }
}

void PlannerNode::carryOut(const sylph::mission_command::Plan& command) {
  planning_ = std::async(std::launch::async, command.make);
  if (const auto& lock_step = clock_.lockStep()) {
    // Otherwise the machine's mood would decide at which moment of the lab a plan is ready.
    lock_step->holdUntil([this] {
      return planning_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
  }
}

void PlannerNode::carryOut(const sylph::mission_command::Publish& command) {
  try {
    plan_ = sylph_ros::toMessage(command.plan);
    carryOut(sylph::mission_command::PublishAgain());
  } catch (const std::invalid_argument& error) {
    lifecycle_.fail(
        {sylph::MissionOutcome::NoPlan, std::string("the plan cannot be sent: ") + error.what()},
        clock_.now());
  }
}

void PlannerNode::carryOut(const sylph::mission_command::PublishAgain& /*command*/) {
  plan_.header.stamp = clock_.stamp();
  joint_actions_publisher_.publish(plan_);
}

void PlannerNode::carryOut(const sylph::mission_command::Withdraw& /*command*/) {
  plan_ = sylph_msgs::JointActions();
  carryOut(sylph::mission_command::PublishAgain());
}

void PlannerNode::carryOut(const sylph::mission_command::Say& command) {
  if (command.level == sylph::mission_command::Say::Level::Info) {
    ROS_INFO("%s", command.text.c_str());
  } else if (command.level == sylph::mission_command::Say::Level::Warning) {
    ROS_WARN("%s", command.text.c_str());
  } else {
    ROS_ERROR("%s", command.text.c_str());
  }
}

void PlannerNode::carryOut(const sylph::mission_command::End& command) {
  const sylph_msgs::ExecuteMissionResult result = toMessage(command.result);
  if (command.result.outcome == sylph::MissionOutcome::Success) {
    server_.setSucceeded(result, result.message);
  } else if (command.result.outcome == sylph::MissionOutcome::Preempted) {
    server_.setPreempted(result, result.message);
  } else {
    server_.setAborted(result, result.message);
  }
}

void PlannerNode::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.summary(diagnostic_msgs::DiagnosticStatus::OK, toString(lifecycle_.stage()));
  if (!lifecycle_.hasHeardCentral()) {
    status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "central node not heard of yet");
  }
  const sylph::MissionResult& totals = lifecycle_.totals();
  status.add("last mission", lifecycle_.lastOutcome());
  status.add("plan_id", lifecycle_.planId());
  status.add("replans", totals.replans);
  status.add("planning_s", totals.planning_s);
  status.add("planner", lifecycle_.mission().planner);
}

}  // namespace sylph_planner_node
