#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "sylph_core/control/robot_controller.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/grid/rng.hpp"

namespace sylph {

/// One robot in a 5 x 5 world, in simulated time: 50 Hz control, 100 Hz poses, 10 Hz central node.
class RobotWorld {
 public:
  explicit RobotWorld(const Cell& start, const RobotControllerOptions& options = {})
      : grid(5, 5), frame(grid, 0.3), controller(options, grid, frame) {
    pose = {frame.toPoint(start).x, frame.toPoint(start).y, 0.0};
    central_sends = true;
    cameras_send = true;
  }

  /// Tasks along a row of plan 1, from (2,0) eastwards.
  void sendEastward(int count) {
    for (int k = 0; k < count; ++k) {
      controller.onTask({1, k, {2, k}, {2, k + 1}}, now_s);
    }
  }

  /// Tasks of plan 1 along a path of cells.
  void sendAlong(const std::vector<Cell>& path) {
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      controller.onTask({1, static_cast<int>(k), path[k], path[k + 1]}, now_s);
    }
  }

  void run(double duration_s) {
    const double end_s = now_s + duration_s - 1e-9;
    while (now_s < end_s) {
      step();
    }
  }

  void stopAndResume() {
    mode = ExecutionMode::Stop;
    run(0.3);
    mode = ExecutionMode::Run;
    run(0.3);
  }

  /// The operator stops all, looks, confirms the robot's pose, and lets all go on.
  PoseConfirmation stopConfirmAndResume() {
    mode = ExecutionMode::Stop;
    run(0.3);
    PoseConfirmation confirmation = controller.confirmPose(now_s);
    mode = ExecutionMode::Run;
    run(0.3);
    return confirmation;
  }

  void loseSightFor(double duration_s) {
    cameras_send = false;
    run(duration_s);
    cameras_send = true;
  }

  /// The node gets no processor time; the base stops by itself `base_timeout_s` after the last
  /// command.
  void starveNodeFor(double duration_s) {
    node_runs = false;
    run(duration_s);
    node_runs = true;
  }

  RobotReport report() const { return controller.report(now_s); }
  double speedNow() const { return speed(command_robot); }
  double x() const { return pose.x_m; }

  Grid grid;
  CellFrame frame;
  RobotController controller;
  Pose2d pose;                       // true
  Pose2d camera_offset;              // added to what the cameras tell
  std::optional<Pose2d> other_body;  // whose pose they tell instead
  Twist2d command_robot;
  double grip = 1.0;  // share of the wheels' motion that reaches the floor
  ExecutionMode mode = ExecutionMode::Run;
  std::uint32_t executed_plan_id = 1;
  bool has_tasks_to_come = false;
  bool is_aligning = false;
  bool central_sends = true;
  bool cameras_send = true;
  bool node_runs = true;
  double base_timeout_s = ExecutionSpec{}.base_timeout_s;
  double now_s = 50.0;

 private:
  void step() {  // 0.01 s
    if (node_runs && central_sends && step_ % 10 == 0) {
      controller.onCentralState({mode, executed_plan_id, now_s, has_tasks_to_come, is_aligning},
                                now_s);
    }
    if (node_runs && cameras_send) {
      const double noise_m = 1e-4 * drawNormal(rng_);
      const Pose2d& body = other_body ? *other_body : pose;
      controller.onPose({{body.x_m + camera_offset.x_m + noise_m, body.y_m + camera_offset.y_m,
                          body.yaw_rad + camera_offset.yaw_rad},
                         now_s,
                         now_s,
                         now_s});
    }
    if (node_runs && step_ % 2 == 0) {
      command_robot = controller.update(now_s);
      commanded_s_ = now_s;
    } else if (now_s - commanded_s_ > base_timeout_s) {
      command_robot = {};
    }
    const Twist2d target_map = mapFromRobot(command_robot, pose.yaw_rad);
    const double share = 1.0 - std::exp(-0.01 / 0.1);
    wheel_map_.x_mps += share * (target_map.x_mps - wheel_map_.x_mps);
    wheel_map_.y_mps += share * (target_map.y_mps - wheel_map_.y_mps);
    pose.x_m += 0.01 * grip * wheel_map_.x_mps;
    pose.y_m += 0.01 * grip * wheel_map_.y_mps;
    pose.yaw_rad += 0.01 * target_map.turn_radps;
    ++step_;
    now_s += 0.01;
  }

  int step_ = 0;
  double commanded_s_ = 0.0;
  Twist2d wheel_map_;
  Rng rng_{1};
};

}  // namespace sylph
