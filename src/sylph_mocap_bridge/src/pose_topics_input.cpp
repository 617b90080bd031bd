#include "sylph_mocap_bridge/pose_topics_input.hpp"

#include <ros/master.h>
#include <ros/this_node.h>
#include <ros/time.h>

#include <algorithm>
#include <stdexcept>

namespace sylph_mocap_bridge {
namespace {

constexpr std::uint32_t kQueueSize = 10;

/// The locale must not matter: a topic's name is ASCII.
bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool mayFollow(char c) {
  return isLetter(c) || (c >= '0' && c <= '9') || c == '_' || c == '/';
}

std::string cleaned(std::string name, const sylph::RobotSpec& robot) {
  const std::string whole = name;
  if (!name.empty() && !isLetter(name.front()) && name.front() != '/') {
    name.erase(0, 1);
  }
  name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return !mayFollow(c); }),
             name.end());
  if (std::all_of(name.begin(), name.end(), [](char c) { return c == '/'; })) {
    throw std::runtime_error("'" + whole + "' of " + robot.name +
                             ": nothing of it may be in a topic's name, rename the rigid body or "
                             "use {robot} in pose_topic");
  }
  return name;
}

void replaceAll(std::string& text, const std::string& placeholder, const std::string& name,
                const sylph::RobotSpec& robot) {
  if (text.find(placeholder) == std::string::npos) {
    return;
  }
  const std::string clean = cleaned(name, robot);
  for (std::size_t at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder, at + clean.size())) {
    text.replace(at, placeholder.size(), clean);
  }
}

/// Topics of poses that others publish.
std::vector<std::string> foreignPoseTopics() {
  ros::master::V_TopicInfo published;
  ros::master::getTopics(published);
  ros::V_string own;
  ros::this_node::getAdvertisedTopics(own);
  std::vector<std::string> topics;
  for (const ros::master::TopicInfo& topic : published) {
    if (topic.datatype == "geometry_msgs/PoseStamped" &&
        std::find(own.begin(), own.end(), topic.name) == own.end()) {
      topics.push_back(topic.name);
    }
  }
  return topics;
}

}  // namespace

std::string poseTopic(const std::string& pattern, const sylph::RobotSpec& robot) {
  std::string topic = pattern;
  replaceAll(topic, "{rigid_body}", robot.rigid_body, robot);
  replaceAll(topic, "{robot}", robot.name, robot);
  return topic;
}

PoseTopicsInput::PoseTopicsInput(ros::NodeHandle& nh, const std::string& pattern, StampPolicy stamp,
                                 const std::vector<sylph::RobotSpec>& robots, MeasurementSink& sink)
    : stamp_(stamp), sink_(sink), new_messages_(robots.size()) {
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    const std::string topic = poseTopic(pattern, robots[robot]);
    // Drivers clean names in this way, so that two bodies may end on one topic: one robot would
    // drive by the other's pose.
    const auto same = std::find(topics_.begin(), topics_.end(), topic);
    if (same != topics_.end()) {
      const auto other = static_cast<std::size_t>(same - topics_.begin());
      throw std::runtime_error("robots " + robots[other].name + " and " + robots[robot].name +
                               " would both follow " + topic +
                               ": give their rigid bodies names that differ in letters or digits");
    }
    topics_.push_back(topic);
    subscribers_.push_back(nh.subscribe<geometry_msgs::PoseStamped>(
        topic, kQueueSize,
        [this, robot](const geometry_msgs::PoseStamped::ConstPtr& message) {
          onPose(*message, robot);
        },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  }
}

void PoseTopicsInput::onPose(const geometry_msgs::PoseStamped& message, std::size_t robot) {
  ++new_messages_[robot];
  const double now_s = ros::Time::now().toSec();
  if (now_s < last_now_s_ - kTimeJump_s) {
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
  std::vector<std::string> unpublished;
  std::vector<std::string> silent;
  for (std::size_t robot = 0; robot < subscribers_.size(); ++robot) {
    const std::string topic = subscribers_[robot].getTopic();
    report.add("messages on " + topic, new_messages_[robot]);
    if (new_messages_[robot] == 0) {
      (subscribers_[robot].getNumPublishers() == 0 ? unpublished : silent).push_back(topic);
    }
    new_messages_[robot] = 0;
  }
  return topicsFinding(unpublished, silent,
                       unpublished.empty() ? std::vector<std::string>() : foreignPoseTopics());
}

}  // namespace sylph_mocap_bridge
