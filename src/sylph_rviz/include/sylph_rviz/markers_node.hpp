#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <sylph_msgs/JointActions.h>

#include <memory>
#include <string>
#include <vector>

#include "sylph_ros/steady_clock.hpp"
#include "sylph_rviz/conversions.hpp"
#include "sylph_rviz/layer_history.hpp"
#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/options.hpp"
#include "sylph_rviz/selected_robot.hpp"

namespace sylph_rviz {

/// Draws the run: collects poses, AdgState and separation into a Scene and sends each layer at a
/// fixed rate of wall time, so that a layer that was switched off comes back at once.
///
/// With an experiment it knows robots and map from the start and publishes the footprints. Without,
/// as in a replay, it takes all of them from topics.
class MarkersNode {
 public:
  /// @throws std::runtime_error on a bad parameter or experiment
  MarkersNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  struct RobotInput {
    ros::Subscriber pose;
    ros::Subscriber footprint;
    ros::Publisher footprint_publisher;
    double pose_received_s = 0.0;
  };
  struct LayerOutput {
    ros::Publisher publisher;
    LayerHistory history;
  };

  void onAdgState(const sylph_msgs::AdgState& message);
  void onJointActions(const sylph_msgs::JointActions& message);
  void onMap(const nav_msgs::OccupancyGrid& message);
  void onPose(std::size_t robot, const geometry_msgs::PoseStamped& message);
  void listenTo(std::size_t robot);
  void publishLayers();

  ros::NodeHandle nh_;
  Options options_;
  sylph_ros::SteadyClock clock_;
  bool has_experiment_ = false;
  Scene scene_;
  std::vector<RobotInput> inputs_;  // as scene_.robots
  double last_input_s_ = 0.0;       // when a pose or AdgState came last
  std::vector<LayerOutput> outputs_;
  ros::Time published_at_;
  ros::Subscriber state_subscriber_;
  ros::Subscriber separation_subscriber_;
  ros::Subscriber map_subscriber_;
  ros::Subscriber plan_subscriber_;
  ros::Subscriber shown_plan_subscriber_;
  SelectedRobot selected_robot_;
  ros::SteadyTimer timer_;
};

}  // namespace sylph_rviz
