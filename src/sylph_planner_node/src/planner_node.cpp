#include "sylph_planner_node/planner_node.hpp"

#include <nav_msgs/OccupancyGrid.h>

#include <algorithm>
#include <chrono>

#include "sylph_planner_node/occupancy_grid.hpp"
#include "sylph_planner_node/progress.hpp"
#include "sylph_planner_node/replanning.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::ExecuteMissionResult;

std::vector<std::string> namesOf(const sylph::Experiment& lab) {
  std::vector<std::string> names;
  for (const sylph::RobotSpec& robot : lab.robots) {
    names.push_back(robot.name);
  }
  return names;
}

}  // namespace

PlannerNode::PlannerNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
    : nh_(nh),
      options_(loadOptions(private_nh)),
      lab_(sylph_ros::loadExperiment(nh)),
      weights_(lab_.planning.weights_path),
      clock_(sylph_ros::SteadyClock::fromParameter(nh)),
      poses_(nh, clock_),
      mode_(nh),
      joint_actions_publisher_(
          nh_.advertise<sylph_msgs::JointActions>(sylph_ros::kJointActionsTopic, 1, true)),
      map_publisher_(nh_.advertise<nav_msgs::OccupancyGrid>(
          sylph_ros::fleetName(nh_, sylph_ros::kMapTopic), 1, true)),
      adg_state_subscriber_(nh_.subscribe(sylph_ros::kAdgStateTopic, 10, &PlannerNode::onAdgState,
                                          this, ros::TransportHints().tcpNoDelay())),
      server_(nh_, sylph_ros::kExecuteMissionAction, false),
      diagnostics_(nh_, private_nh) {
  // Weights of no use are refused now rather than with the first mission.
  weights_.of(lab_.planning.planner);
  mission_.grid = lab_.grid;
  mission_.cell_size_m = lab_.cell_size_m;
  mission_.corner = lab_.corner;
  publishMap();
  diagnostics_.setHardwareID("none");
  diagnostics_.add("planner", this, &PlannerNode::report);
  server_.registerGoalCallback([this] { onGoal(); });
  server_.registerPreemptCallback([this] { onPreempt(); });
  server_.start();
  map_timer_ = nh_.createSteadyTimer(clock_.wall(options_.map_period_s),
                                     [this](const ros::SteadyTimerEvent&) { publishMap(); });
  tick_timer_ = nh_.createSteadyTimer(clock_.wall(options_.tick_period_s),
                                      [this](const ros::SteadyTimerEvent&) { tick(); });
}

void PlannerNode::onGoal() {
  if (server_.isActive()) {
    abandon();
    ExecuteMissionResult result = totals_;
    result.outcome = ExecuteMissionResult::PREEMPTED;
    result.message = "another mission has taken its place";
    server_.setPreempted(result, result.message);
  }
  const auto goal = server_.acceptNewGoal();
  totals_ = ExecuteMissionResult();
  replans_ = 0;
  replaces_plan_id_ = 0;
  given_up_.clear();
  withdrawPlan();
  try {
    mission_ = readMission(*goal, lab_, weights_);
  } catch (const MissionFailure& failure) {
    fail(failure);
    return;
  }
  totals_.robots = static_cast<std::uint32_t>(mission_.robots.size());
  publishMap();
  poses_.start(namesOf(lab_));
  enter(Stage::Starting);
  if (server_.isPreemptRequested()) {
    onPreempt();
  }
}

void PlannerNode::onPreempt() {
  // A new goal calls this first; onGoal() then ends the old mission itself.
  if (!server_.isActive() || server_.isNewGoalAvailable()) {
    return;
  }
  abandon();
  enter(Stage::Pausing);
}

void PlannerNode::onAdgState(const AdgState& state) {
  state_ = state;
  state_received_s_ = clock_.now();
}

void PlannerNode::publishMap() {
  nav_msgs::OccupancyGrid map =
      toOccupancyGrid(mission_.grid, mission_.cell_size_m, mission_.corner);
  map.header.stamp = ros::Time::now();
  map.info.map_load_time = map.header.stamp;
  map_publisher_.publish(map);
}

void PlannerNode::tick() {
  diagnostics_.update();
  if (const auto error = mode_.takeError()) {
    ROS_ERROR("%s", error->c_str());
  }
  try {
    switch (stage_) {
      case Stage::Idle:
        return;
      case Stage::Starting:
        tickStarting();
        break;
      case Stage::Planning:
        tickPlanning();
        break;
      case Stage::Sending:
        tickSending();
        break;
      case Stage::Executing:
        tickExecuting();
        break;
      case Stage::Pausing:
        tickPausing();
        break;
    }
  } catch (const MissionFailure& failure) {
    fail(failure);
  }
  publishFeedback();
}

void PlannerNode::tickStarting() {
  // What the central node said before the mission may be out of date.
  if (!isCentralHeard() || state_received_s_ < stage_since_s_ || isPlanningThreadBusy()) {
    return;
  }
  if (isExecutionOf(mission_, *state_)) {
    ROS_INFO("plan %u of this mission is under way: going on with it", state_->plan_id);
    plan_id_ = state_->plan_id;
    follow();
    return;
  }
  if (isPreviousMissionMoving()) {
    return;
  }
  try {
    startPlanning();
  } catch (const MissionFailure& failure) {
    const double waited_s = (clock_.now() - stage_since_s_) / clock_.speed();
    if (failure.outcome() != ExecuteMissionResult::NO_POSE || waited_s > options_.pose_wait_s) {
      throw;
    }
  }
}

void PlannerNode::tickPlanning() {
  if (isPlanningThreadBusy()) {
    return;
  }
  send(planning_.get());
}

void PlannerNode::tickSending() {
  if (!isCentralHeard()) {
    return;
  }
  if (state_->plan_id == plan_id_ && state_->phase == AdgState::REFUSED) {
    throw MissionFailure(ExecuteMissionResult::PLAN_REFUSED,
                         "the central node refused the plan: " + state_->message);
  }
  if (state_->plan_id == plan_id_ && state_->phase != AdgState::PENDING) {
    follow();
  } else if (clock_.now() - sent_s_ >= options_.resend_period_s) {
    publishPlan();
  }
}

void PlannerNode::tickExecuting() {
  if (state_->plan_id > plan_id_) {
    throw MissionFailure(ExecuteMissionResult::PLAN_REFUSED,
                         "plan " + std::to_string(plan_id_) + " was replaced by plan " +
                             std::to_string(state_->plan_id) + " of another mission");
  }
  if (state_->plan_id < plan_id_) {
    if (plan_) {
      ROS_WARN("the central node has lost plan %u: sending it again", plan_id_);
      publishPlan();
      enter(Stage::Sending);
    }
    return;
  }
  switch (state_->phase) {
    case AdgState::FINISHED:
      finish(finishedResult(mission_, *state_, given_up_));
      break;
    case AdgState::REFUSED:
      throw MissionFailure(ExecuteMissionResult::PLAN_REFUSED,
                           "the central node refused the plan: " + state_->message);
    case AdgState::AT_CUT:
      startReplanning();
      break;
    default:
      break;
  }
}

void PlannerNode::tickPausing() {
  const bool is_too_late = clock_.now() - stage_since_s_ > options_.hold_wait_s;
  const bool was_under_way = mode_.isPausedByUs();
  if (was_under_way && !is_too_late && !(state_ && allHold(*state_))) {
    return;
  }
  ExecuteMissionResult result;
  if (state_) {
    result.arrived = robotsArrived(mission_, *state_);
    result.execution_s = was_under_way ? state_->elapsed_s : 0.0;
  }
  result.outcome = ExecuteMissionResult::PREEMPTED;
  result.message = !was_under_way ? "cancelled before a robot moved"
                   : is_too_late  ? "cancelled; the central node does not say that robots hold"
                                  : "cancelled: the robots hold at their next cells";
  finish(result);
}

void PlannerNode::startPlanning() {
  const double now_s = clock_.now();
  const sylph::Configuration starts =
      startCells(mission_, poses_.poses(), now_s, options_.pose_timeout_s);
  const sylph::Instance instance =
      toInstance(mission_, starts,
                 cellsOfBystanders(mission_, lab_, poses_.poses(), now_s, options_.pose_timeout_s));
  poses_.stop();
  planned_robots_ = mission_.robots;
  planning_ = std::async(std::launch::async, planMission, mission_, instance);
  enter(Stage::Planning);
}

void PlannerNode::startReplanning() {
  RestOfMission rest = restOfMission(mission_, *state_);
  for (const std::string& line : rest.given_up) {
    ROS_WARN("%s", line.c_str());
  }
  given_up_ = rest.given_up;
  planned_robots_ = rest.robots;
  replaces_plan_id_ = plan_id_;
  ++replans_;
  Mission limited = mission_;
  limited.time_limit_s = std::min(limited.time_limit_s, options_.replanning_time_limit_s);
  planning_ = std::async(std::launch::async, planAsFarAsPossible, limited, rest.instance);
  enter(Stage::Planning);
}

void PlannerNode::send(const CheckedPlan& plan) {
  totals_.planning_s += plan.planning_s;
  totals_.plan_steps = static_cast<std::uint32_t>(plan.metrics.steps);
  totals_.sum_of_costs = static_cast<std::uint32_t>(plan.metrics.sum_of_costs);
  // The central node and the robots remember plans even when this node has been started again.
  const std::uint32_t known = state_ ? std::max(state_->plan_id, state_->last_plan_id) : 0;
  plan_id_ = std::max(plan_id_, known) + 1;
  ROS_INFO("plan %u by %s: %d steps, sum of costs %ld, %.2f s", plan_id_, mission_.planner.c_str(),
           plan.metrics.steps, plan.metrics.sum_of_costs, plan.planning_s);
  sylph::MissionPlan mission_plan = toMissionPlan(plan, planned_robots_, mission_.planner);
  mission_plan.plan_id = plan_id_;
  mission_plan.replaces_plan_id = replaces_plan_id_;
  try {
    plan_ = sylph_ros::toMessage(mission_plan);
  } catch (const std::invalid_argument& error) {
    throw MissionFailure(ExecuteMissionResult::NO_PLAN,
                         std::string("the plan cannot be sent: ") + error.what());
  }
  publishPlan();
  enter(Stage::Sending);
}

void PlannerNode::publishPlan() {
  sent_s_ = clock_.now();
  plan_->header.stamp = ros::Time::now();
  joint_actions_publisher_.publish(*plan_);
}

void PlannerNode::withdrawPlan() {
  if (plan_) {
    plan_ = sylph_msgs::JointActions();
    publishPlan();
    plan_.reset();
  }
}

void PlannerNode::follow() {
  if (mode_.isPausedByUs()) {
    mode_.resume();
  }
  enter(Stage::Executing);
}

void PlannerNode::publishFeedback() {
  const double now_s = clock_.now();
  if (stage_ == Stage::Idle || now_s - feedback_sent_s_ < options_.feedback_period_s) {
    return;
  }
  feedback_sent_s_ = now_s;
  std::string phase;
  switch (stage_) {
    case Stage::Planning:
      phase = replaces_plan_id_ == 0 ? "planning" : "replanning";
      break;
    case Stage::Sending:
      phase = "sending";
      break;
    case Stage::Executing:
      phase = state_->phase == AdgState::CUTTING ? "cutting" : "executing";
      break;
    case Stage::Pausing:
      phase = "pausing";
      break;
    default:
      phase = "starting";
      break;
  }
  const bool has_plan = stage_ == Stage::Executing || stage_ == Stage::Pausing;
  server_.publishFeedback(toFeedback(phase, mission_, has_plan && state_ ? *state_ : AdgState()));
}

void PlannerNode::enter(Stage stage) {
  stage_ = stage;
  stage_since_s_ = clock_.now();
}

bool PlannerNode::isCentralHeard() {
  const double now_s = clock_.now();
  const double silent_since_s =
      state_ ? std::max(stage_since_s_, state_received_s_) : stage_since_s_;
  if ((now_s - silent_since_s) / clock_.speed() > options_.central_wait_s) {
    throw MissionFailure(
        ExecuteMissionResult::PLAN_REFUSED,
        "the central node is silent: no message on " + adg_state_subscriber_.getTopic());
  }
  return state_.has_value();
}

void PlannerNode::fail(const MissionFailure& failure) {
  ExecuteMissionResult result;
  result.outcome = failure.outcome();
  result.message = failure.what();
  if (state_ && stage_ != Stage::Idle) {
    result.arrived = robotsArrived(mission_, *state_);
  }
  finish(result);
}

void PlannerNode::finish(ExecuteMissionResult result) {
  result.robots = totals_.robots;
  result.planning_s = totals_.planning_s;
  result.plan_steps = totals_.plan_steps;
  result.sum_of_costs = totals_.sum_of_costs;
  result.replans = replans_;
  poses_.stop();
  withdrawPlan();
  enter(Stage::Idle);
  last_outcome_ = result.message;
  if (result.outcome == ExecuteMissionResult::SUCCESS) {
    ROS_INFO("mission ends: %s", result.message.c_str());
    server_.setSucceeded(result, result.message);
  } else if (result.outcome == ExecuteMissionResult::PREEMPTED) {
    ROS_INFO("mission ends: %s", result.message.c_str());
    server_.setPreempted(result, result.message);
  } else {
    ROS_ERROR("mission ends: %s", result.message.c_str());
    server_.setAborted(result, result.message);
  }
}

void PlannerNode::abandon() {
  const bool is_under_way = stage_ == Stage::Sending || stage_ == Stage::Executing ||
                            (stage_ == Stage::Planning && replaces_plan_id_ != 0);
  if (is_under_way) {
    mode_.pause();
  }
}

bool PlannerNode::isPlanningThreadBusy() const {
  return planning_.valid() &&
         planning_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

bool PlannerNode::isPreviousMissionMoving() const {
  if (!isBusy(*state_) || allHold(*state_)) {
    return false;
  }
  const bool may_wait =
      mode_.isPausedByUs() && clock_.now() - stage_since_s_ < options_.hold_wait_s;
  if (!may_wait) {
    throw MissionFailure(ExecuteMissionResult::BAD_REQUEST,
                         "plan " + std::to_string(state_->plan_id) +
                             " of another mission is being carried out: cancel that one first");
  }
  return true;
}

void PlannerNode::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  static constexpr const char* kStageNames[] = {"idle",    "starting",  "planning",
                                                "sending", "executing", "pausing"};
  status.summary(diagnostic_msgs::DiagnosticStatus::OK, kStageNames[static_cast<int>(stage_)]);
  if (!state_) {
    status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "central node not heard of yet");
  }
  status.add("last mission", last_outcome_);
  status.add("plan_id", plan_id_);
  status.add("replans", replans_);
  status.add("planning_s", totals_.planning_s);
  status.add("planner", mission_.planner);
}

}  // namespace sylph_planner_node
