#include "sylph_adg_central/separation_monitor_node.hpp"

#include <std_msgs/Bool.h>
#include <sylph_msgs/SeparationState.h>

#include <cmath>
#include <cstdio>

#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/measured_pose.hpp"
#include "sylph_ros/parameters.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_adg_central {

SeparationMonitorOptions readSeparationMonitorOptions(sylph_ros::ParameterReader& reader) {
  SeparationMonitorOptions options;
  options.limits.limit_m = 0.0;
  reader.read("limit_m", options.limits.limit_m, sylph::Range::atLeast(0.0),
              "a smaller gap between two footprints stops all robots; 0: half of what the safety "
              "margin promises, which it may not exceed");
  reader.read("confirmations", options.limits.confirmations, {1.0, 100.0},
              "poses of a robot in a row that have to show it");
  reader.read("stop_response_s", options.limits.stop_response_s, {0.0, 1.0},
              "of a robot that is told to stop, besides the experiment's command_latency_s: its "
              "control period and its base's lag");
  reader.read("stop_deceleration_mps2", options.limits.stop_deceleration_mps2, {0.01, 100.0},
              "of a robot that is told to stop, as its node has it");
  reader.read("rate_hz", options.rate_hz, sylph::Range::positive(),
              "how often the state is published");
  reader.read("pose_timeout_s", options.pose_timeout_s, sylph::Range::positive(),
              "a pose older than this is called stale in the state");
  return options;
}

SeparationMonitorOptions loadSeparationMonitorOptions(const ros::NodeHandle& private_nh,
                                                      const sylph::Experiment& experiment) {
  sylph_ros::ParameterReader reader(private_nh);
  SeparationMonitorOptions options = readSeparationMonitorOptions(reader);
  reader.refuseUnread();
  const double promised_m = sylph::requireSafetyMargin(experiment).promisedSeparation();
  // Robots that keep to their tolerances come as close as the margin says. Stopping them for that
  // would be a mistake as well.
  if (options.limits.limit_m > promised_m) {
    throw reader.error("limit_m", "must be at most the " + sylph::shortNumber(promised_m) +
                                      " m that the safety margin promises");
  }
  sylph::SeparationLimits limits = sylph::separationLimits(experiment);
  limits.confirmations = options.limits.confirmations;
  limits.stop_response_s = options.limits.stop_response_s;
  limits.stop_deceleration_mps2 = options.limits.stop_deceleration_mps2;
  if (options.limits.limit_m > 0.0) {
    limits.limit_m = options.limits.limit_m;
  }
  options.limits = limits;
  return options;
}

SeparationMonitorNode::SeparationMonitorNode(const ros::NodeHandle& nh,
                                             const ros::NodeHandle& private_nh)
    : nh_(nh),
      clock_(sylph_ros::SteadyClock::fromParameter(nh)),
      experiment_(sylph_ros::loadExperiment(nh)),
      options_(loadSeparationMonitorOptions(private_nh, experiment_)),
      watch_(sylph::footprintsOf(experiment_), options_.limits),
      received_s_(experiment_.robots.size()),
      diagnostics_(nh, private_nh) {
  ROS_INFO("robots are stopped below a gap of %.1f mm", options_.limits.limit_m * 1e3);
  diagnostics_.setHardwareID("none");
  diagnostics_.add("separation", this, &SeparationMonitorNode::reportDiagnostics);
  stop_publisher_ = clock_.advertise<std_msgs::Bool>(nh_, sylph_ros::kEmergencyStopTopic, 1, true);
  state_publisher_ =
      clock_.advertise<sylph_msgs::SeparationState>(nh_, sylph_ros::kSeparationTopic, 10);
  publishStop();
  reset_service_ = nh_.advertiseService(sylph_ros::kSeparationResetService,
                                        &SeparationMonitorNode::onReset, this);
  for (int robot = 0; robot < static_cast<int>(experiment_.robots.size()); ++robot) {
    subscribers_.push_back(clock_.subscribe<geometry_msgs::PoseStamped>(
        nh_, sylph_ros::robotTopic(nh_, name(robot), sylph_ros::kPoseTopic), 10,
        [this, robot](const geometry_msgs::PoseStamped& message) { onPose(robot, message); }));
  }
  timer_ = clock_.createTimer(nh_, 1.0 / options_.rate_hz, [this] { onTimer(); });
}

void SeparationMonitorNode::onPose(int robot, const geometry_msgs::PoseStamped& message) {
  const sylph_ros::JudgedPose judged = sylph_ros::judgePose(message);
  if (judged.fault != sylph_ros::PoseFault::None) {
    ROS_WARN_THROTTLE(1.0, "the pose of %s %s", name(robot).c_str(), judged.reason.c_str());
    return;
  }
  received_s_[static_cast<std::size_t>(robot)] = clock_.now();
  if (!watch_.update(robot, judged.pose, message.header.stamp.toSec()) || is_violated_) {
    return;
  }
  is_violated_ = true;
  publishStop();
  publishState();
  ROS_ERROR("all robots stop: %s", describe(*watch_.violation()).c_str());
}

bool SeparationMonitorNode::onReset(std_srvs::Trigger::Request& /*request*/,
                                    std_srvs::Trigger::Response& response) {
  const sylph::PairGap closest = watch_.closest();
  // The latch protects robots that are too close; a reset there would let them drive on into each
  // other.
  response.success = static_cast<std::uint8_t>(closest.gap_m >= options_.limits.limit_m);
  response.message = describe(closest);
  if (response.success == 0) {
    response.message += ": move them apart first";
    return true;
  }
  is_violated_ = false;
  publishStop();
  publishState();
  return true;
}

void SeparationMonitorNode::onTimer() {
  if (is_violated_) {
    publishStop();
  }
  publishState();
  diagnostics_.update();
}

void SeparationMonitorNode::publishStop() {
  std_msgs::Bool message;
  message.data = static_cast<std::uint8_t>(is_violated_);
  stop_publisher_.publish(message);
}

void SeparationMonitorNode::publishState() {
  sylph_msgs::SeparationState state;
  state.header.stamp = clock_.stamp();
  state.header.frame_id = sylph_ros::kMapFrame;
  const sylph::PairGap closest = watch_.closest();
  state.separation_m = closest.gap_m;
  const sylph::PairGap& ever = watch_.closestEver();
  state.min_separation_m = ever.gap_m;
  if (closest.robot_a >= 0) {
    state.robot_a = name(closest.robot_a);
    state.robot_b = name(closest.robot_b);
  }
  if (ever.robot_a >= 0) {
    state.min_robot_a = name(ever.robot_a);
    state.min_robot_b = name(ever.robot_b);
  }
  state.limit_m = options_.limits.limit_m;
  state.violated = static_cast<std::uint8_t>(is_violated_);
  for (std::size_t robot = 0; robot < received_s_.size(); ++robot) {
    if (!received_s_[robot] || clock_.now() - *received_s_[robot] > options_.pose_timeout_s) {
      state.without_pose.push_back(experiment_.robots[robot].name);
    }
  }
  state_publisher_.publish(state);
}

void SeparationMonitorNode::reportDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  if (is_violated_) {
    status.summary(DiagnosticStatus::ERROR, "all robots stop: " + describe(*watch_.violation()));
  } else {
    status.summary(DiagnosticStatus::OK, describe(watch_.closest()));
  }
  status.add("limit_m", options_.limits.limit_m);
  status.add("min_separation_m", watch_.closestEver().gap_m);
}

std::string SeparationMonitorNode::describe(const sylph::PairGap& pair) const {
  if (pair.robot_a < 0) {
    return "no two robots have poses";
  }
  char gap[32];
  std::snprintf(gap, sizeof(gap), "%.1f mm", pair.gap_m * 1e3);
  return name(pair.robot_a) + " and " + name(pair.robot_b) + " are " + gap + " apart";
}

const std::string& SeparationMonitorNode::name(int robot) const {
  return experiment_.robots.at(static_cast<std::size_t>(robot)).name;
}

}  // namespace sylph_adg_central
