#pragma once

#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sylph_msgs/ExecuteMissionAction.h>

#include <atomic>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sylph_ros/capture_findings.hpp"
#include "sylph_rviz/experiment_choices.hpp"
#include "sylph_rviz/goal_markers.hpp"
#include "sylph_rviz/layer_history.hpp"
#include "sylph_rviz/operator_model.hpp"
#include "sylph_rviz/selected_robot.hpp"
#include "sylph_rviz/trigger_call.hpp"

namespace sylph_rviz {

/// What an operator has chosen to run.
struct MissionChoice {
  std::string experiment_path;        ///< absolute
  std::string planner;                ///< empty: the experiment's
  std::optional<std::uint32_t> seed;  ///< of what the experiment calls random; nothing: its own
};

/// The panel's end of the ROS graph. It has threads of its own, and no call of it waits for a node,
/// the master or a file: RViz goes on whatever becomes of those.
class OperatorLink {
 public:
  /// @param suite_nh  in the suite's namespace
  explicit OperatorLink(const ros::NodeHandle& suite_nh);
  ~OperatorLink();
  OperatorLink(const OperatorLink&) = delete;
  OperatorLink& operator=(const OperatorLink&) = delete;

  /// What there is to show now.
  OperatorView view() const;
  /// What the lab can run; empty as long as the lab's own experiment is not known.
  std::vector<ExperimentChoice> experiments() const;
  /// How the last command ended, in one line, once; empty: nothing new.
  std::string takeOutcome();

  /// Tells everybody which robot the operator looks at; empty: none.
  void select(const std::string& robot);
  /// Moves a replay.
  /// @param place_s  from the beginning of its bag [s]
  void seek(double place_s);

  /// Plans the goals that are set by hand and shows the plan; nothing moves.
  void plan();
  /// Sends the shown plan off.
  void go();
  /// Takes back the goals that are set by hand.
  void clearGoals();
  /// Whether robots without a goal may step aside and come back.
  void setOthersGiveWay(bool others_give_way);
  /// Writes the goals that are set by hand as an experiment file, which must not be there yet.
  void save(const std::string& path);

  /// Sends the mission of an experiment to the planner.
  void start(const MissionChoice& choice);
  /// Ends the mission: robots hold at their next cells.
  void cancel();
  /// Robots finish the tasks that they have.
  void pause() { pause_.call(); }
  /// Robots go on after a pause or stop.
  void resume() { resume_.call(); }
  /// Robots ramp to zero at once.
  void stop() { stop_.call(); }
  /// The operator has looked at a robot: its pose is right.
  void confirmPose(const std::string& robot);

 private:
  using Client = actionlib::SimpleActionClient<sylph_msgs::ExecuteMissionAction>;

  void serveCallbacks();
  void watchGraph();
  void lookAround();
  void onState(const sylph_msgs::AdgState& state);
  void listenToPose(const std::string& robot);
  void listenToGoals();
  void serveMouse(bool sends_goals);
  void onMouse(const GoalEvent& event);
  void setGoal(const std::string& robot, const sylph::Point& point);
  void onNavGoal(const geometry_msgs::PoseStamped& goal);
  void takeLab(const std::string& path);
  void tell(const std::string& outcome);

  ros::NodeHandle nh_;
  ros::CallbackQueue queue_;
  mutable std::mutex mutex_;  ///< of the model, the choices and the outcome
  OperatorModel model_;
  std::vector<ExperimentChoice> experiments_;
  std::string lab_path_;
  std::string outcome_;
  std::map<std::string, ros::Subscriber> poses_;  ///< of the thread that serves callbacks
  std::vector<ros::Subscriber> subscribers_;
  std::unique_ptr<SelectedRobot> selected_robot_;
  ros::Publisher seek_;
  ros::Publisher goals_;
  std::optional<sylph_msgs::ExecuteMissionGoal> planned_;  ///< what the planner was asked to show
  LayerHistory goals_history_;                             ///< of the thread that serves callbacks
  GoalMarkers markers_;
  std::unique_ptr<Client> client_;
  std::unique_ptr<Client> plan_client_;
  TriggerCall pause_;
  TriggerCall resume_;
  TriggerCall stop_;
  sylph_ros::CaptureFindings capture_findings_;  ///< of the thread that serves callbacks
  std::unique_ptr<TriggerCall> confirm_pose_;    ///< of the robot that was confirmed last
  std::future<void> start_;
  std::future<void> save_;
  std::atomic<bool> is_ending_{false};
  std::thread callbacks_;
  std::thread graph_;
};

}  // namespace sylph_rviz
