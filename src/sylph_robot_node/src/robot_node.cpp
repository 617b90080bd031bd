#include "sylph_robot_node/robot_node.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>
#include <ros/init.h>

#include <algorithm>
#include <string>

#include "sylph_robot_node/conversions.hpp"
#include "sylph_robot_node/shutdown_request.hpp"
#include "sylph_ros/measured_pose.hpp"
#include "sylph_ros/state_messages.hpp"
#include "sylph_ros/task_messages.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_robot_node {
namespace {

constexpr double kShutdownPeriodWall_s = 0.1;
/// A simulator that has not been heard for so long has ended before this node [wall s].
constexpr double kSimulatorGoneWall_s = 0.5;

sylph::CentralState centralState(const sylph_msgs::AdgState& message, sylph::ExecutionMode mode,
                                 const std::string& robot) {
  sylph::CentralState state;
  state.mode = mode;
  state.executed_plan_id = message.executed_plan_id;
  state.stamp_s = message.header.stamp.toSec();
  for (const sylph_msgs::RobotExecution& known : message.robots) {
    if (known.robot_id == robot) {
      state.has_tasks_to_come = known.tasks_done < known.tasks_total;
      state.is_aligning = known.aligning != 0;
    }
  }
  return state;
}

}  // namespace

RobotNode::RobotNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : options_(loadOptions(nh, private_nh)),
      clock_(sylph_ros::SteadyClock::fromParameter(sylph_ros::suiteHandle(nh))),
      frame_(options_.grid, options_.cell_size_m, options_.corner),
      controller_(options_.controller, options_.grid, frame_),
      reporter_(options_.report_rate_hz),
      nh_(nh),
      updater_(nh, private_nh) {
  catchShutdownSignals();
  command_publisher_ = clock_.advertise<geometry_msgs::Twist>(nh_, sylph_ros::kCommandTopic, 1);
  report_publisher_ =
      clock_.advertise<sylph_msgs::TaskReport>(nh_, sylph_ros::kTaskReportTopic, 10);
  task_subscriber_ = clock_.subscribe<sylph_msgs::Task>(
      nh_, sylph_ros::kTaskTopic, 100, [this](const sylph_msgs::Task& task) { onTask(task); });
  // Over TCP a lost pose holds up those behind it for longer than a robot may drive without one.
  const ros::TransportHints pose_hints =
      options_.poses_by_udp ? ros::TransportHints().unreliable().reliable().tcpNoDelay()
                            : ros::TransportHints().tcpNoDelay();
  pose_subscriber_ = clock_.subscribe<geometry_msgs::PoseStamped>(
      nh_, sylph_ros::kPoseTopic, 1,
      [this](const geometry_msgs::PoseStamped& pose) { onPose(pose); }, pose_hints);
  const ros::NodeHandle suite = sylph_ros::suiteHandle(nh_);
  adg_state_subscriber_ = clock_.subscribe<sylph_msgs::AdgState>(
      suite, sylph_ros::kAdgStateTopic, 1,
      [this](const sylph_msgs::AdgState& state) { onAdgState(state); });
  emergency_subscriber_ = clock_.subscribe<std_msgs::Bool>(
      suite, sylph_ros::kEmergencyStopTopic, 10,
      [this](const std_msgs::Bool& stop) { onEmergencyStop(stop); });
  confirm_pose_server_ =
      nh_.advertiseService(sylph_ros::kConfirmPoseService, &RobotNode::onConfirmPose, this);
  updater_.setHardwareID(options_.robot);
  updater_.add("control",
               [this](diagnostic_updater::DiagnosticStatusWrapper& status) { diagnose(status); });
  timer_ = clock_.createTimer(nh_, 1.0 / options_.control_rate_hz, [this] { onTick(); });
  // The ramp needs lab time, which stands still once the simulator has gone.
  if (clock_.lockStep()) {
    shutdown_timer_ =
        nh_.createSteadyTimer(ros::WallDuration(kShutdownPeriodWall_s),
                              [this](const ros::SteadyTimerEvent&) { goDownWithoutSimulator(); });
  }
}

void RobotNode::onTask(const sylph_msgs::Task& message) {
  if (message.robot_id != options_.robot) {
    ROS_WARN_THROTTLE(1.0, "task for %s on the topic of %s", message.robot_id.c_str(),
                      options_.robot.c_str());
    return;
  }
  std::string reason;
  const auto task = sylph_ros::fromMessage(message, frame_, reason);
  if (!task) {
    ROS_WARN_THROTTLE(1.0, "%s", reason.c_str());
    return;
  }
  const double now_s = clock_.now();
  const sylph::TaskAnswer answer = controller_.onTask(*task, now_s);
  if (answer.verdict == sylph::TaskVerdict::Refused) {
    ROS_WARN_THROTTLE(1.0, "%s", answer.reason.c_str());
  } else if (!answer.reason.empty()) {
    ROS_DEBUG("%s", answer.reason.c_str());
  }
  report(now_s);
}

void RobotNode::onPose(const geometry_msgs::PoseStamped& message) {
  const sylph_ros::JudgedPose judged = sylph_ros::judgePose(message);
  if (judged.fault != sylph_ros::PoseFault::None) {
    ROS_WARN_THROTTLE(1.0, "the pose of %s %s", options_.robot.c_str(), judged.reason.c_str());
  }
  if (judged.fault == sylph_ros::PoseFault::Frame) {
    return;  // of another robot or frame, not a failed measurement
  }
  const double now_s = clock_.now();
  const double age_s = (clock_.stamp() - message.header.stamp).toSec();
  controller_.onPose(sylph::timedPose(judged.pose, message.header.stamp.toSec(), age_s, now_s));
  report(now_s);
}

void RobotNode::onAdgState(const sylph_msgs::AdgState& message) {
  if (const auto mode = sylph_ros::modeFromMessage(message)) {
    controller_.onCentralState(centralState(message, *mode, options_.robot), clock_.now());
  } else {
    ROS_WARN_THROTTLE(1.0, "AdgState with mode %d: must be RUN, PAUSE or STOP", message.mode);
  }
}

void RobotNode::onEmergencyStop(const std_msgs::Bool& message) {
  controller_.onEmergencyStop(message.data != 0);
}

bool RobotNode::onConfirmPose(std_srvs::Trigger::Request& /*request*/,
                              std_srvs::Trigger::Response& response) {
  const sylph::PoseConfirmation confirmation = controller_.confirmPose(clock_.now());
  response.success = static_cast<std::uint8_t>(confirmation.is_confirmed);
  response.message = options_.robot + ": " + confirmation.message;
  ROS_INFO("the operator confirms the pose: %s", response.message.c_str());
  return true;
}

void RobotNode::onTick() {
  const double now_s = clock_.now();
  if (isShutdownRequested()) {
    goDown(now_s);
    return;
  }
  command_publisher_.publish(toMessage(controller_.update(now_s)));
  report(now_s);
  updater_.update();
  if (ticked_s_) {
    largest_tick_s_ = std::max(largest_tick_s_, now_s - *ticked_s_);
  }
  ticked_s_ = now_s;
}

void RobotNode::goDown(double now_s) {
  if (!shutdown_since_s_) {
    shutdown_since_s_ = now_s;
  }
  command_publisher_.publish(toMessage(controller_.rampDown(now_s)));
  if (now_s - *shutdown_since_s_ >= options_.shutdown_s) {
    // A base without a timeout of its own keeps the last command for ever.
    command_publisher_.publish(geometry_msgs::Twist());
    ros::requestShutdown();
  }
}

void RobotNode::goDownWithoutSimulator() {
  if (isShutdownRequested() && clock_.lockStep()->silence() > kSimulatorGoneWall_s) {
    ros::requestShutdown();
  }
}

void RobotNode::report(double now_s) {
  const auto report = reporter_.offer(controller_.report(now_s), now_s);
  if (!report) {
    return;
  }
  sylph_msgs::TaskReport message = sylph_ros::toMessage(*report);
  message.robot_id = options_.robot;
  message.header.stamp = clock_.stamp();
  message.header.frame_id = sylph_ros::kMapFrame;
  report_publisher_.publish(message);
}

void RobotNode::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const sylph::RobotReport& report = reporter_.last();
  const bool is_well =
      report.state == sylph::RobotState::Idle || report.state == sylph::RobotState::Moving;
  status.summary(
      is_well ? diagnostic_msgs::DiagnosticStatus::OK : diagnostic_msgs::DiagnosticStatus::WARN,
      report.detail.empty() ? "driving" : report.detail);
  status.add("plan", report.plan_id);
  status.add("tasks accepted", report.accepted);
  status.add("tasks done", report.done);
  status.add("tracking error [m]", report.tracking_error_m);
  status.add("heading error [rad]", report.heading_error_rad);
  status.add("pose age [s]", report.pose_age_s);
  status.add("longest control period [s]", largest_tick_s_);
}

}  // namespace sylph_robot_node
