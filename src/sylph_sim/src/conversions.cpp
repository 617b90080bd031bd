#include "sylph_sim/conversions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sylph_sim {
namespace {

/// The server had been up for a while.
constexpr double kUptimeAtStart = 3600.0;

sylph_natnet::RigidBodySample toSample(const CapturedBody& body, std::size_t robot, UpAxis up_axis,
                                       double height_m) {
  const auto x = static_cast<float>(body.pose.x_m);
  const auto y = static_cast<float>(body.pose.y_m);
  const auto z = static_cast<float>(height_m);
  const auto qz = static_cast<float>(std::sin(body.pose.yaw_rad / 2.0));
  const auto qw = static_cast<float>(std::cos(body.pose.yaw_rad / 2.0));
  sylph_natnet::RigidBodySample sample;
  sample.id = bodyId(robot);
  if (up_axis == UpAxis::Z) {
    sample.position_m = {x, y, z};
    sample.orientation_xyzw = {0.0F, 0.0F, qz, qw};
  } else {
    sample.position_m = {x, z, -y};
    sample.orientation_xyzw = {0.0F, qz, 0.0F, qw};
  }
  sample.mean_error_m = 0.0003F;
  sample.tracked = body.is_tracked;
  return sample;
}

}  // namespace

std::uint64_t toTicks(double since_start_s) {
  return static_cast<std::uint64_t>(
      std::llround((since_start_s + kUptimeAtStart) * static_cast<double>(kTicksPerSecond)));
}

std::int32_t bodyId(std::size_t robot) {
  return static_cast<std::int32_t>(robot) + 1;
}

sylph_natnet::Frame toNatNet(const CapturedFrame& frame, double start_s, UpAxis up_axis,
                             double body_height_m) {
  sylph_natnet::Frame message;
  message.number = frame.number;
  for (std::size_t robot = 0; robot < frame.bodies.size(); ++robot) {
    message.rigid_bodies.push_back(toSample(frame.bodies[robot], robot, up_axis, body_height_m));
  }
  message.timestamp_s = frame.captured_s - start_s;
  message.latency_s = static_cast<float>(frame.sent_s - frame.captured_s);
  message.mid_exposure_ticks = toTicks(frame.captured_s - start_s);
  // Most of the latency is exposure and transfer, the rest is the solver's.
  message.data_received_ticks =
      toTicks(frame.captured_s - start_s + 0.8 * (frame.sent_s - frame.captured_s));
  message.transmit_ticks = toTicks(frame.sent_s - start_s);
  return message;
}

sylph_natnet::ModelDefinitions modelDefinitions(const sylph::Experiment& experiment) {
  sylph_natnet::ModelDefinitions definitions;
  for (std::size_t robot = 0; robot < experiment.robots.size(); ++robot) {
    sylph_natnet::RigidBodyDefinition definition;
    definition.name = experiment.robots[robot].rigid_body;
    definition.id = bodyId(robot);
    definitions.rigid_bodies.push_back(definition);
  }
  return definitions;
}

geometry_msgs::Pose2D toMessage(const sylph::Pose2d& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x_m;
  message.y = pose.y_m;
  message.theta = pose.yaw_rad;
  return message;
}

Fault fromMessage(const sylph_msgs::InjectFaultRequest& request,
                  const sylph::Experiment& experiment) {
  Fault fault;
  fault.kind = faultKindFromName(request.kind);
  for (const std::string& robot : request.robots) {
    fault.robots.push_back(robotIndex(experiment, robot));
  }
  fault.at_s = request.delay_s;
  if (request.duration_s != 0.0) {
    fault.duration_s = request.duration_s;
  }
  fault.value = request.value != 0.0 ? request.value : defaultValue(fault.kind);
  return fault;
}

std::size_t robotIndex(const sylph::Experiment& experiment, const std::string& name) {
  const auto found =
      std::find_if(experiment.robots.begin(), experiment.robots.end(),
                   [&name](const sylph::RobotSpec& robot) { return robot.name == name; });
  if (found == experiment.robots.end()) {
    throw std::runtime_error("robot '" + name + "': the experiment has none of that name");
  }
  return static_cast<std::size_t>(std::distance(experiment.robots.begin(), found));
}

}  // namespace sylph_sim
