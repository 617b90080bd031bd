#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/ExecuteMissionFeedback.h>
#include <sylph_msgs/ExecuteMissionResult.h>
#include <sylph_msgs/ReplayExtent.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_rviz/goal_desk.hpp"
#include "sylph_rviz/goal_handle.hpp"
#include "sylph_rviz/scene.hpp"

namespace sylph_rviz {

/// Who is on the other end of the panel's topics.
enum class Source {
  None,   ///< nobody sends the state of execution
  Live,   ///< a central node
  Replay  ///< a bag: there is no node to command
};

/// One robot as a line of the operator's table. What is not known is empty.
struct RobotRow {
  std::string name;                           ///< as in the experiment
  RobotStatus status = RobotStatus::Unknown;  ///< decides the row's colour
  std::string state;                          ///< its status in a word
  std::string cell;                           ///< where it is, "(row,col)", or "no pose"
  std::string waits;                          ///< for whom and how long
  std::string reason;              ///< why it does not go on, down to who holds everybody up
  std::vector<std::string> chain;  ///< a line for each robot that waits for the next, from this one
  std::string partner;             ///< its name
  std::optional<double> svo_deg;   ///< 0: selfish, 45: prosocial
  std::optional<double> pose_age_s;        ///< since its last pose was measured
  std::optional<double> tracking_error_m;  ///< from the way that it has to drive
};

/// A robot's SVO over the timesteps of the plan that is carried out.
struct SvoSeries {
  std::string robot;
  std::vector<float> svo_deg;  ///< one per joint action, 0 selfish ... 45 prosocial; NaN: none
};

/// Where a replay is in its bag.
struct ReplayPosition {
  double at_s = 0.0;      ///< from the bag's beginning [s]
  double length_s = 0.0;  ///< of the bag [s]
};

/// All that the operator's panel shows.
struct OperatorView {
  std::string headline;   ///< where the mission stands
  std::string message;    ///< how it ended, or why it does not go on; empty: nothing to say
  bool is_alarm = false;  ///< whether `message` asks for the operator
  int tasks_done = 0;     ///< of all robots
  int tasks_total = 0;    ///< of all robots, in the present plan
  std::optional<double> elapsed_s;       ///< since the plan was begun
  std::optional<double> left_s;          ///< at the pace so far; nothing before there is one
  std::optional<ReplayPosition> replay;  ///< nothing if this is none, or it cannot be moved
  std::vector<RobotRow> rows;            ///< in the order of the plan's robots
  std::string selected;                  ///< the robot that the operator looks at; empty: none
  std::vector<SvoSeries> svo;  ///< of the selected robot, then of its partner, if they have any
  std::uint32_t svo_step = 0;  ///< timestep at which the selected robot is
  std::string goals;           ///< that are set by hand, and what was planned of them
  Refusal start;               ///< of a mission
  Refusal pause;               ///< of the lab
  Refusal resume;              ///< after a pause or stop
  Refusal stop;                ///< of the lab, at once
  Refusal cancel;              ///< of the mission
  Refusal confirm_pose;        ///< of any one robot
  Refusal set_goal;            ///< by hand
  Refusal plan;                ///< of the goals that are set
  Refusal go;                  ///< with the plan that is shown
  Refusal clear_goals;         ///< of those that are set
  Refusal save;                ///< of the goals that are set, as an experiment
};

/// What is known of a run, from messages alone: no clock, no ROS. Times are told by the caller, in
/// seconds: ROS time for what robots do, steady time for what nodes do.
class OperatorModel {
 public:
  /// @param source  of the messages
  /// @param has_planner  whether a planner takes missions
  void setSource(Source source, bool has_planner);
  /// Takes over a state, and learns of its robots.
  void onState(const sylph_msgs::AdgState& state, double steady_s);
  /// A robot's good pose, measured at `stamp_s` of ROS time.
  void onPose(const std::string& robot, const sylph::Pose2d& pose, double stamp_s);
  /// Cells and their size; a map without cells changes nothing.
  void onMap(const nav_msgs::OccupancyGrid& map);
  /// A replay tells which part of time its bag covers.
  void onReplayExtent(const sylph_msgs::ReplayExtent& extent) { replay_extent_ = extent; }
  /// A plan that the planner has sent.
  void onPlan(sylph::MissionPlan plan) { scene_.plan = std::move(plan); }
  /// The planner says how far it is, at `steady_s` [s].
  void onFeedback(const sylph_msgs::ExecuteMissionFeedback& feedback, double steady_s);
  /// What the motion capture lacks, one line each.
  void setCaptureFindings(std::vector<std::string> lines) { capture_findings_ = std::move(lines); }
  /// The robot that the operator looks at; empty: none.
  void select(const std::string& robot) { scene_.selected = robot; }
  /// A mission has ended.
  void onResult(const sylph_msgs::ExecuteMissionResult& result);

  /// Goals that are set by hand.
  GoalDesk& desk() { return desk_; }
  const GoalDesk& desk() const { return desk_; }
  /// Of the robots, as far as they have come.
  sylph::RobotPoses poses() const;
  /// What there is to click and to drag. Goals only while they can be set.
  std::vector<GoalHandle> handles(double steady_s) const;

  /// Robots, their poses and what they do.
  const Scene& scene() const { return scene_; }
  /// What there is to show at these times [s].
  OperatorView view(double ros_s, double steady_s) const;

 private:
  bool hasState(double steady_s) const;
  bool isPlanning(double steady_s) const;
  bool isUnderWay(double steady_s) const;
  std::string headline(double steady_s) const;
  void addMessage(OperatorView& view, double steady_s) const;
  void addCaptureFindings(OperatorView& view, double steady_s) const;
  void addCommands(OperatorView& view, double steady_s) const;
  Refusal goalRefusal(double steady_s) const;
  void addGoals(OperatorView& view, double steady_s) const;
  void addSvo(OperatorView& view) const;
  std::optional<sylph::Point> handleOf(const RobotView& robot) const;
  RobotRow rowOf(const RobotView& robot, double ros_s) const;

  Source source_ = Source::None;
  bool has_planner_ = false;
  Scene scene_;
  GoalDesk desk_;
  std::optional<double> state_heard_s_;
  std::map<std::string, double> pose_stamps_s_;
  std::optional<sylph_msgs::ExecuteMissionFeedback> feedback_;
  double feedback_heard_s_ = 0.0;
  std::vector<std::string> capture_findings_;
  std::optional<sylph_msgs::ReplayExtent> replay_extent_;
  std::optional<sylph_msgs::ExecuteMissionResult> result_;
};

/// "4.2 s", "3 min 05 s".
std::string durationText(double seconds);

/// Why a robot does not go on: its fault, or for whom it waits, how long, and who holds them all
/// up. Empty if it goes on.
std::string waitText(const sylph_msgs::RobotExecution& robot);

/// The chain of waits from a robot to the one that holds it up, a line each; empty if it goes on.
std::vector<std::string> chainText(const Scene& scene, const std::string& robot);

/// How far a robot is from the way that it has to drive now [m]; nothing without pose, task or map.
std::optional<double> trackingError(const Scene& scene, const RobotView& robot);

}  // namespace sylph_rviz
