#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <ros/time.h>
#include <ros/wall_timer.h>
#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <mutex>
#include <vector>

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph_robot_node {

/// Everything around the node of robot_0: a base that does what it is told, cameras at 100 Hz and
/// a central node at 10 Hz.
class MockLab {
 public:
  explicit MockLab(const sylph::Cell& start);

  void sendTask(std::uint32_t plan, std::uint32_t sequence, const sylph::Cell& from,
                const sylph::Cell& to);
  void setEmergency(bool is_pressed);
  void setMode(std::uint8_t mode);
  void setCameras(bool on);
  /// Adds to x of what the cameras tell [m].
  void setCameraOffset(double offset_m);
  void setCentral(bool on);
  /// The base stands turned from now on.
  void turn(double angle_rad);
  /// Whether the central node wants the robot to be aligned.
  void setAligning(bool on);

  sylph_msgs::TaskReport report() const;
  geometry_msgs::Twist command() const;
  sylph::Pose2d pose() const;
  std::size_t commandCount() const;
  /// AdgStates sent so far.
  int stateCount() const;
  /// Connected to everything that the node publishes and subscribes.
  bool isConnected() const;
  bool hasCommander() const { return command_subscriber_.getNumPublishers() > 0; }

 private:
  void step();

  mutable std::mutex mutex_;
  sylph::CellFrame frame_{3, 0.3};
  ros::NodeHandle nh_{"/robot_0"};
  ros::Publisher pose_publisher_;
  ros::Publisher task_publisher_;
  ros::Publisher state_publisher_;
  ros::Publisher emergency_publisher_;
  ros::Subscriber command_subscriber_;
  ros::Subscriber report_subscriber_;
  ros::WallTimer timer_;
  ros::AsyncSpinner spinner_{1};

  sylph::Pose2d pose_;
  sylph::Twist2d twist_;
  geometry_msgs::Twist command_;
  std::size_t commands_ = 0;
  sylph_msgs::TaskReport report_;
  std::uint8_t mode_ = 0;
  std::uint32_t executed_plan_id_ = 0;
  bool cameras_on_ = true;
  double camera_offset_m_ = 0.0;
  bool central_on_ = false;
  bool aligning_on_ = false;
  int steps_ = 0;
  int states_ = 0;
};

}  // namespace sylph_robot_node
