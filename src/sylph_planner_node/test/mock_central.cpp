#include "mock_central.hpp"

#include <geometry_msgs/PoseStamped.h>

#include <algorithm>
#include <stdexcept>

#include "mission/small_lab.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"

namespace sylph_planner_node {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

namespace {

geometry_msgs::PoseStamped poseIn(const sylph::Mission& mission, const sylph::Cell& cell) {
  const sylph::Pose2d point = sylph::pose2dIn(mission, cell);
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = "map";
  pose.pose.position.x = point.x_m;
  pose.pose.position.y = point.y_m;
  pose.pose.orientation.w = 1.0;
  return pose;
}

}  // namespace

MockCentral::MockCentral(const sylph::Mission& mission, const sylph::Configuration& starts)
    : mission_(mission) {
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    RobotExecution robot;
    robot.robot_id = mission.robots[i];
    robot.cell = sylph_ros::toMessage(starts[i]);
    robot.held_cells = {robot.cell};
    state_.robots.push_back(robot);
    pose_publishers_[robot.robot_id] =
        nh_.advertise<geometry_msgs::PoseStamped>("/" + robot.robot_id + "/pose", 1);
  }
  state_publisher_ = nh_.advertise<AdgState>(sylph_ros::kAdgStateTopic, 10);
  subscriber_ = nh_.subscribe(sylph_ros::kJointActionsTopic, 1, &MockCentral::onJointActions, this);
  pause_server_ = nh_.advertiseService(sylph_ros::kPauseService, &MockCentral::onPause, this);
  resume_server_ = nh_.advertiseService(sylph_ros::kResumeService, &MockCentral::onResume, this);
  timer_ = nh_.createSteadyTimer(ros::WallDuration(0.02),
                                 [this](const ros::SteadyTimerEvent&) { tick(); });
}

void MockCentral::dropOnePlan() {
  const std::lock_guard<std::mutex> lock(mutex_);
  drops_ = true;
}

void MockCentral::refusePlans(const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  refusal_ = reason;
}

void MockCentral::silencePoseOf(const std::string& robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  without_pose_.insert(robot);
}

void MockCentral::beSilent() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_silent_ = true;
}

void MockCentral::haltAfter(std::uint32_t steps) {
  const std::lock_guard<std::mutex> lock(mutex_);
  halt_after_ = steps;
}

void MockCentral::lose(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  robot(name).condition = RobotExecution::LOST;
  state_.phase = AdgState::CUTTING;
}

void MockCentral::pretendToExecute(std::uint32_t plan_id, const sylph::Configuration& goals) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.plan_id = plan_id;
  state_.phase = AdgState::EXECUTING;
  state_.steps = 1;
  halt_after_ = 0;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    state_.robots[i].goal = sylph_ros::toMessage(goals[i]);
    state_.robots[i].tasks_total = 1;
  }
}

void MockCentral::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (RobotExecution& robot : state_.robots) {
    robot.cell = robot.goal;
    robot.tasks_done = robot.tasks_total;
  }
  state_.phase = AdgState::FINISHED;
}

void MockCentral::setPlanId(std::uint32_t plan_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.plan_id = plan_id;
}

bool MockCentral::waitForStatesOnTheirWay() const {
  const auto published = [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return published_;
  };
  const std::uint32_t before = published();
  return sylph_ros::waitUntil([&] { return published() >= before + 3; });
}

AdgState MockCentral::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

std::vector<sylph_msgs::JointActions> MockCentral::received() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return received_;
}

sylph::Plan MockCentral::plan() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return plan_.plan;
}

void MockCentral::onJointActions(const sylph_msgs::JointActions& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (message.plan_id == 0) {
    return;
  }
  received_.push_back(message);
  if (drops_ || message.plan_id <= state_.plan_id) {
    drops_ = false;
    return;
  }
  plan_ = sylph_ros::fromMessage(message);
  next_step_ = 0;
  state_.plan_id = message.plan_id;
  state_.steps = plan_.steps();
  state_.phase = refusal_.empty() ? AdgState::EXECUTING : AdgState::REFUSED;
  state_.message = refusal_;
  for (std::size_t agent = 0; agent < plan_.robots.size(); ++agent) {
    robot(plan_.robots[agent]).goal = sylph_ros::toMessage(plan_.goals[agent]);
    robot(plan_.robots[agent]).tasks_total = plan_.steps();
    robot(plan_.robots[agent]).tasks_done = 0;
  }
}

bool MockCentral::onPause(std_srvs::Trigger::Request& /*request*/,
                          std_srvs::Trigger::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.mode = AdgState::PAUSE;
  response.success = 1;
  return true;
}

bool MockCentral::onResume(std_srvs::Trigger::Request& /*request*/,
                           std_srvs::Trigger::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.mode = AdgState::RUN;
  response.success = 1;
  return true;
}

void MockCentral::tick() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_.phase == AdgState::CUTTING) {
    state_.phase = AdgState::AT_CUT;
  } else if (state_.phase == AdgState::EXECUTING && state_.mode == AdgState::RUN) {
    advance();
  }
  publish();
}

void MockCentral::advance() {
  if (next_step_ >= halt_after_) {
    return;
  }
  if (next_step_ >= state_.steps) {
    state_.phase = AdgState::FINISHED;
    return;
  }
  for (std::size_t agent = 0; agent < plan_.robots.size(); ++agent) {
    RobotExecution& moved = robot(plan_.robots[agent]);
    moved.cell = sylph_ros::toMessage(plan_.plan.at(next_step_ + 1)[agent]);
    moved.held_cells = {moved.cell};
    moved.tasks_done = next_step_ + 1;
  }
  ++next_step_;
}

void MockCentral::publish() {
  ++published_;
  if (!is_silent_) {
    state_.header.stamp = ros::Time::now();
    state_publisher_.publish(state_);
  }
  for (const RobotExecution& robot : state_.robots) {
    if (without_pose_.count(robot.robot_id) == 0) {
      pose_publishers_[robot.robot_id].publish(
          poseIn(mission_, sylph_ros::fromMessage(robot.cell)));
    }
  }
}

RobotExecution& MockCentral::robot(const std::string& name) {
  const auto found = std::find_if(state_.robots.begin(), state_.robots.end(),
                                  [&](const RobotExecution& r) { return r.robot_id == name; });
  if (found == state_.robots.end()) {
    throw std::out_of_range("no robot " + name);
  }
  return *found;
}

}  // namespace sylph_planner_node
