#include "sylph_mocap_bridge/pose_topics_input.hpp"

#include <ros/time.h>

#include <cctype>

namespace sylph_mocap_bridge {
namespace {

constexpr std::uint32_t kQueueSize = 10;
/// ROS time that goes back by more than this began anew (a simulation, a bag).
constexpr double kTimeJumpS = 0.5;

void replaceAll(std::string& text, const std::string& placeholder, const std::string& name) {
  for (std::size_t at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder, at + name.size())) {
    text.replace(at, placeholder.size(), name);
  }
}

std::string cleaned(std::string name) {
  for (char& letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) {
      letter = '_';
    }
  }
  return name;
}

}  // namespace

std::string poseTopic(const std::string& pattern, const sylph::RobotSpec& robot) {
  std::string topic = pattern;
  replaceAll(topic, "{rigid_body}", cleaned(robot.rigid_body));
  replaceAll(topic, "{robot}", cleaned(robot.name));
  return topic;
}

PoseTopicsInput::PoseTopicsInput(ros::NodeHandle& nh, const std::string& pattern, StampPolicy stamp,
                                 const std::vector<sylph::RobotSpec>& robots, MeasurementSink& sink)
    : stamp_(stamp), sink_(sink), new_messages_(robots.size()) {
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    subscribers_.push_back(nh.subscribe<geometry_msgs::PoseStamped>(
        poseTopic(pattern, robots[robot]), kQueueSize,
        [this, robot](const geometry_msgs::PoseStamped::ConstPtr& message) {
          onPose(*message, robot);
        },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  }
}

void PoseTopicsInput::onPose(const geometry_msgs::PoseStamped& message, std::size_t robot) {
  ++new_messages_[robot];
  const double now_s = ros::Time::now().toSec();
  if (now_s < last_now_s_ - kTimeJumpS) {
    sink_.onRestart();
  }
  last_now_s_ = now_s;
  const bool has_stamp = !message.header.stamp.isZero() && stamp_ != StampPolicy::Receive;
  const double stamp_s = has_stamp ? message.header.stamp.toSec() : now_s;
  const auto& p = message.pose.position;
  const auto& q = message.pose.orientation;
  sink_.onMeasurements({{robot, true, {p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}, stamp_s, stamp_s}},
                       now_s);
}

Finding PoseTopicsInput::look(diagnostic_updater::DiagnosticStatusWrapper& report) {
  Finding finding{Severity::Ok, "poses of all robots come"};
  for (std::size_t robot = 0; robot < subscribers_.size(); ++robot) {
    const std::string topic = subscribers_[robot].getTopic();
    report.add("messages on " + topic, new_messages_[robot]);
    if (new_messages_[robot] == 0) {
      finding = {Severity::Error,
                 subscribers_[robot].getNumPublishers() == 0
                     ? "nobody publishes " + topic +
                           ": is the driver running, and are pose_topic and the rigid body's name "
                           "right?"
                     : "nothing comes on " + topic + ": does the driver see that body?"};
    }
    new_messages_[robot] = 0;
  }
  return finding;
}

}  // namespace sylph_mocap_bridge
