#include "sylph_rviz/selected_robot.hpp"

#include <ros/single_subscriber_publisher.h>
#include <std_msgs/String.h>

#include <utility>

#include "sylph_ros/topics.hpp"

namespace sylph_rviz {
namespace {

std_msgs::String toMessage(const std::string& robot) {
  std_msgs::String message;
  message.data = robot;
  return message;
}

}  // namespace

SelectedRobot::SelectedRobot(const ros::NodeHandle& suite_nh, Listener on_heard)
    : nh_(suite_nh), on_heard_(std::move(on_heard)) {
  publisher_ = nh_.advertise<std_msgs::String>(
      sylph_ros::kSelectedRobotTopic, 1,
      [this](const ros::SingleSubscriberPublisher& newcomer) { tellNewcomer(newcomer); });
  subscriber_ = nh_.subscribe<std_msgs::String>(sylph_ros::kSelectedRobotTopic, 1,
                                                [this](const std_msgs::String::ConstPtr& robot) {
                                                  keep(robot->data);
                                                  on_heard_(robot->data);
                                                });
}

void SelectedRobot::set(const std::string& robot) {
  keep(robot);
  publisher_.publish(toMessage(robot));
}

void SelectedRobot::keep(const std::string& robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  robot_ = robot;
}

void SelectedRobot::tellNewcomer(const ros::SingleSubscriberPublisher& newcomer) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (robot_) {
    newcomer.publish(toMessage(*robot_));
  }
}

}  // namespace sylph_rviz
