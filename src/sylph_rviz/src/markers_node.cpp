#include "sylph_rviz/markers_node.hpp"

#include <ros/console.h>

#include <utility>

#include "sylph_ros/experiment.hpp"
#include "sylph_ros/measured_pose.hpp"
#include "sylph_ros/parameters.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_rviz {

MarkersNode::MarkersNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : nh_(nh),
      options_(sylph_ros::readStrictly(private_nh, readOptions)),
      clock_(sylph_ros::SteadyClock::ofSpectator(nh_)),
      selected_robot_(nh_, [this](const std::string& robot) { scene_.selected = robot; }) {
  std::string experiment;
  sylph_ros::read(nh_, sylph_ros::kExperimentParameter, experiment);
  has_experiment_ = !experiment.empty();
  if (has_experiment_) {
    scene_ = sceneOf(sylph_ros::loadExperiment(nh_));
    for (std::size_t robot = 0; robot < scene_.robots.size(); ++robot) {
      listenTo(robot);
    }
  }
  outputs_.resize(kLayers.size());
  for (std::size_t i = 0; i < kLayers.size(); ++i) {
    // Twice in a marker's life, as one message may be lost.
    outputs_[i].history = LayerHistory(0.5 * options_.lifetime_s);
    outputs_[i].publisher = nh_.advertise<visualization_msgs::MarkerArray>(
        kLayers.at(i).topic, 1,
        [this, i](const ros::SingleSubscriberPublisher&) { outputs_[i].history.sendAll(); });
  }
  state_subscriber_ = nh_.subscribe(sylph_ros::kAdgStateTopic, 1, &MarkersNode::onAdgState, this);
  map_subscriber_ =
      nh_.subscribe(sylph_ros::fleetName(nh_, sylph_ros::kMapTopic), 1, &MarkersNode::onMap, this);
  separation_subscriber_ = nh_.subscribe<sylph_msgs::SeparationState>(
      sylph_ros::kSeparationTopic, 1, [this](const sylph_msgs::SeparationState::ConstPtr& message) {
        scene_.separation = *message;
      });
  plan_subscriber_ =
      nh_.subscribe(sylph_ros::kJointActionsTopic, 1, &MarkersNode::onJointActions, this);
  shown_plan_subscriber_ = nh_.subscribe<sylph_msgs::JointActions>(
      sylph_ros::kShownPlanTopic, 1, [this](const sylph_msgs::JointActions::ConstPtr& message) {
        scene_.shown_plan = planOf(*message);  // none: it is withdrawn
      });
  // Wall time: the picture stays alive when a simulation or a replay is paused.
  timer_ = nh_.createSteadyTimer(ros::WallDuration(1.0 / options_.rate_hz),
                                 [this](const ros::SteadyTimerEvent&) { publishLayers(); });
}

void MarkersNode::onAdgState(const sylph_msgs::AdgState& message) {
  last_input_s_ = clock_.now();
  setState(scene_, message);
  while (inputs_.size() < scene_.robots.size()) {
    listenTo(inputs_.size());
  }
}

void MarkersNode::onJointActions(const sylph_msgs::JointActions& message) {
  // When the mission is over its plan stays to be looked at.
  if (auto plan = planOf(message)) {
    scene_.plan = std::move(plan);
  }
}

void MarkersNode::onMap(const nav_msgs::OccupancyGrid& message) {
  if (const auto extent = extentOf(message)) {
    scene_.map = extent;
  } else {
    ROS_WARN_THROTTLE(1.0, "dropped a map without cells or resolution");
  }
}

void MarkersNode::onPose(std::size_t robot, const geometry_msgs::PoseStamped& message) {
  const sylph_ros::JudgedPose judged = sylph_ros::judgePose(message);
  if (judged.fault != sylph_ros::PoseFault::None) {
    ROS_WARN_THROTTLE(1.0, "the pose of %s %s", scene_.robots[robot].name.c_str(),
                      judged.reason.c_str());
    return;
  }
  setPose(scene_.robots[robot], judged.pose);
  last_input_s_ = clock_.now();
  inputs_[robot].pose_received_s = last_input_s_;
}

void MarkersNode::listenTo(std::size_t robot) {
  const RobotView& view = scene_.robots[robot];
  const std::string footprint_topic =
      sylph_ros::robotTopic(nh_, view.name, sylph_ros::kFootprintTopic);
  RobotInput input;
  input.pose = nh_.subscribe<geometry_msgs::PoseStamped>(
      sylph_ros::robotTopic(nh_, view.name, sylph_ros::kPoseTopic), 1,
      [this, robot](const geometry_msgs::PoseStamped::ConstPtr& message) {
        onPose(robot, *message);
      });
  if (has_experiment_) {
    input.footprint_publisher =
        nh_.advertise<geometry_msgs::PolygonStamped>(footprint_topic, 1, true);
    input.footprint_publisher.publish(footprintOf(view));
  } else {
    input.footprint = nh_.subscribe<geometry_msgs::PolygonStamped>(
        footprint_topic, 1, [this, robot](const geometry_msgs::PolygonStamped::ConstPtr& message) {
          setFootprint(scene_.robots[robot], *message);
        });
  }
  inputs_.push_back(std::move(input));
}

void MarkersNode::publishLayers() {
  for (std::size_t robot = 0; robot < scene_.robots.size(); ++robot) {
    // Not the time since: when nothing at all comes any more, a replay is paused or at its end.
    const double age_s = last_input_s_ - inputs_[robot].pose_received_s;
    scene_.robots[robot].pose_is_stale = age_s > options_.pose_timeout_s;
  }
  // RViz counts a marker's lifetime in ROS time, which runs faster in a fast simulation.
  const double lifetime_s = options_.lifetime_s * clock_.speed();
  const ros::Time now = ros::Time::now();
  for (std::size_t i = 0; i < kLayers.size(); ++i) {
    LayerOutput& output = outputs_[i];
    if (now < published_at_) {
      output.history.sendAll();  // RViz forgets everything when time goes back
    }
    if (output.publisher.getNumSubscribers() == 0) {
      continue;
    }
    const visualization_msgs::MarkerArray message = output.history.update(
        kLayers.at(i).draw(scene_), lifetime_s, ros::SteadyTime::now().toSec());
    if (!message.markers.empty()) {
      output.publisher.publish(message);
    }
  }
  published_at_ = now;
}

}  // namespace sylph_rviz
