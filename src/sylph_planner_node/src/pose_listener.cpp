#include "sylph_planner_node/pose_listener.hpp"

#include "sylph_ros/measured_pose.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {

void PoseListener::start(const std::vector<std::string>& robots) {
  stop();
  poses_.clear();
  for (const std::string& robot : robots) {
    subscribers_.push_back(clock_.subscribe<geometry_msgs::PoseStamped>(
        nh_, sylph_ros::robotTopic(nh_, robot, sylph_ros::kPoseTopic), 1,
        [this, robot](const geometry_msgs::PoseStamped& pose) {
          poses_[robot] = {pose, clock_.now()};
        }));
  }
}

void PoseListener::stop() {
  subscribers_.clear();
}

sylph::RobotPoses PoseListener::judged(double timeout_s) const {
  sylph::RobotPoses poses;
  for (const auto& [robot, measured] : poses_) {
    const sylph_ros::JudgedPose judged =
        sylph_ros::judgePose(measured.pose, clock_.now() - measured.received_s, timeout_s);
    poses[robot] = {judged.pose, judged.reason};
  }
  return poses;
}

}  // namespace sylph_planner_node
