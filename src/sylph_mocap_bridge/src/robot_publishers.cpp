#include "sylph_mocap_bridge/robot_publishers.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>

#include "sylph_mocap_bridge/conversions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_mocap_bridge {
namespace {

constexpr std::uint32_t kQueueSize = 10;

}  // namespace

RobotPublishers::RobotPublishers(ros::NodeHandle& nh, const sylph_ros::SteadyClock& clock,
                                 const std::vector<std::string>& robots, const PublishRates& rates,
                                 const TrackerOptions& noise)
    : noise_(noise) {
  for (const std::string& name : robots) {
    const auto topic = [&](const char* of_robot) {
      return sylph_ros::robotTopic(nh, name, of_robot);
    };
    robots_.push_back(
        {name,
         clock.advertise<geometry_msgs::PoseStamped>(nh, topic(sylph_ros::kPoseTopic), kQueueSize),
         nh.advertise<nav_msgs::Odometry>(topic(sylph_ros::kOdometryTopic), kQueueSize),
         RateGate(rates.pose_hz), RateGate(rates.odom_hz), RateGate(rates.tf_hz)});
  }
}

void RobotPublishers::publish(const std::vector<ReliablePose>& poses) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const ReliablePose& pose : poses) {
    Robot& robot = robots_.at(pose.robot);
    if (robot.pose_gate.passes(pose.stamp_s)) {
      robot.pose.publish(toPoseStamped(pose));
    }
    if (pose.velocity && robot.odometry_gate.passes(pose.stamp_s)) {
      robot.odometry.publish(toOdometry(pose, robot.name, noise_));
    }
    if (robot.tf_gate.passes(pose.stamp_s)) {
      transforms.push_back(toTransform(pose, robot.name));
    }
  }
  if (!transforms.empty()) {
    broadcaster_.sendTransform(transforms);
  }
}

}  // namespace sylph_mocap_bridge
