#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sylph_core/control/alignment.hpp"
#include "sylph_core/control/arrival.hpp"
#include "sylph_core/control/motion_watch.hpp"
#include "sylph_core/control/path_follower.hpp"
#include "sylph_core/control/pose_predictor.hpp"
#include "sylph_core/control/pose_watch.hpp"
#include "sylph_core/control/robot_supervisor.hpp"
#include "sylph_core/control/slip_estimator.hpp"
#include "sylph_core/control/task_queue.hpp"
#include "sylph_core/control/twist_limiter.hpp"
#include "sylph_core/execution/robot_report.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph {

/// All that a robot's node can be set to; bounds beside each.
struct RobotControllerOptions {
  double period_s = 0.02;               ///< of update(), > 0
  double stop_deceleration_mps2 = 1.0;  ///< of a ramp to zero, > 0
  double cell_margin_m = 0.012;         ///< by which a robot may leave its cells unnoticed, >= 0
  int arrival_poses = 2;                ///< in a row that show an arrival, > 0
  BaseModel base;
  TwistLimits limits;
  SlipOptions slip;
  FollowerOptions follower;
  ArrivalOptions arrival;
  PoseWatchOptions watch;
  MotionWatchOptions motion;
  SupervisorLimits supervisor;
};

/// What AdgState tells a robot of the central node.
struct CentralState {
  ExecutionMode mode = ExecutionMode::Run;
  std::uint32_t executed_plan_id = 0;  ///< whose tasks it may carry out; 0: of none
  double stamp_s = 0.0;                ///< when it was sent, by the central node's clock
  bool has_tasks_to_come = false;      ///< whether that plan moves this robot still
  /// Whether it is to turn to its heading and drive to the middle of the cell in which it stands,
  /// before its plan begins.
  bool is_aligning = false;
};

/// What a robot says to the operator's word that its pose is right.
struct PoseConfirmation {
  bool is_confirmed = false;
  std::string message;  ///< where it believes to be from now on, or why there is nothing to confirm
};

/// A robot: tasks and poses in, velocity and arrivals out. Every time is in seconds of one steady
/// clock.
class RobotController {
 public:
  /// @throws std::invalid_argument if an option is out of its bounds
  RobotController(const RobotControllerOptions& options, const Grid& grid, const CellFrame& frame);

  /// Takes a task into the queue, or says why not.
  TaskAnswer onTask(const TaskOrder& task, double now_s);
  /// Takes a pose, learns slip from it and notices arrivals.
  PoseVerdict onPose(const TimedPose& pose);
  /// The central node lives. A state sent before the last one is late, and counts for nothing.
  void onCentralState(const CentralState& state, double now_s);
  /// The operator has looked at this robot and answers for its pose: it is where it is seen, and
  /// moves as it is driven. Only while everybody is stopped. A resume alone confirms nothing, since
  /// it may be for another robot's sake.
  PoseConfirmation confirmPose(double now_s);
  /// Where it is seen and does not believe to be, see PoseWatch::placeToConfirm().
  std::optional<Pose2d> placeToConfirm() const { return watch_.placeToConfirm(); }
  /// The state of the button, which stops at once; see EmergencyLatch.
  void onEmergencyStop(bool is_pressed) { emergency_.onEmergencyStop(is_pressed); }

  /// The velocity to command now [robot frame].
  Twist2d update(double now_s);

  /// The velocity while the node goes down: a ramp to zero.
  Twist2d rampDown(double now_s);

  /// As of the last event; the state as of the last update(). Id and stamp are left to the caller.
  RobotReport report(double now_s) const;

 private:
  RobotSituation situation(double now_s) const;
  bool isDisplaced() const;
  /// Whether it has tasks of a plan that the central node does not carry out.
  bool hasOtherPlansTasks() const;
  Whereabouts whereabouts(double now_s) const;
  void followTasks();
  /// Begins or ends an alignment, as the central node wants.
  void followAlignment(double now_s);
  /// Whether it may have been commanded to move.
  bool isDriven() const { return followed_plan_ != 0 || alignment_; }
  /// Where its commands lead the robot from where it was seen last until the capture of `pose`.
  Pose2d drivenUntil(const TimedPose& pose) const;
  /// Compares what was measured since `before` with what was commanded.
  void watchMotion(const TimedPose& before, const TimedPose& now, const Pose2d& driven);
  void learnSlip(const TimedPose& before, const TimedPose& now, const Twist2d& model_map);
  void detectArrival(const Pose2d& pose, const Twist2d& twist_map);
  int lastWaypoint(Permission permission);
  int reachedWaypoint() const { return tasks_.done() - first_task_; }
  /// Tells the predictor of a command, and gives it as it goes to the base.
  Twist2d noteCommand(const Twist2d& command_map, double now_s);
  double stepTo(double now_s);

  RobotControllerOptions options_;
  CellFrame frame_;
  TaskQueue tasks_;
  PoseWatch watch_;
  MotionWatch motion_;
  PosePredictor predictor_;
  SlipEstimator slip_;
  PathFollower follower_;
  TwistLimiter limiter_;
  EmergencyLatch emergency_;
  CentralState central_;
  std::optional<double> central_heard_s_;
  std::optional<double> updated_s_;
  std::optional<int> finish_waypoint_;  // where to stop while the central node is silent
  std::uint32_t followed_plan_ = 0;
  int first_task_ = 0;  // of the plan, that the path begins with
  std::optional<Alignment> alignment_;
  bool has_aligned_ = false;
  int arrival_poses_ = 0;
  RobotDecision decision_;
  std::string refusal_;  // of the last task that was refused, until one is accepted
};

}  // namespace sylph
