#pragma once

#include <functional>
#include <optional>

#include "sylph_core/control/robot_controller.hpp"
#include "sylph_core/control/robot_reporter.hpp"
#include "sylph_rehearsal/event_queue.hpp"

namespace sylph_rehearsal {

/// What a robot's node is made of, whenever it starts.
struct RobotSetup {
  sylph::RobotControllerOptions controller;
  double report_rate_hz = 10.0;
  sylph::Grid grid;
  sylph::CellFrame frame;
};

/// The node of one robot. While it is down, whatever reaches it is lost.
class Robot {
 public:
  struct Ports {
    std::function<void(const sylph::Twist2d&)> command;
    std::function<void(const sylph::RobotReport&)> report;
  };

  /// @param setup, queue  have to outlive it
  Robot(const RobotSetup& setup, EventQueue& queue, Ports ports)
      : setup_(&setup), queue_(&queue), ports_(std::move(ports)) {}

  /// Its first control period begins now.
  void start();
  /// It ends without a word; the base keeps the last command until its time-out.
  void crash();
  bool isUp() const { return node_.has_value(); }

  void onTask(const sylph::TaskOrder& task);
  void onPose(const sylph::Pose2d& pose, double stamp_s);
  void onCentralState(const sylph::CentralState& state);
  void onEmergencyStop(bool is_pressed);
  /// The operator, who stands beside the robot, confirms its pose if it is shown where it truly is.
  void onLookedAt(const sylph::Pose2d& truth);

  /// How far its clock is ahead [s].
  void setClockOffset(double offset_s) { clock_offset_s_ = offset_s; }
  /// Nothing while it is down.
  const sylph::RobotController* controller() const { return node_ ? &node_->controller : nullptr; }

 private:
  struct Node {
    sylph::RobotController controller;
    sylph::RobotReporter reporter;
  };

  void tick(int life);
  void report();

  const RobotSetup* setup_;
  EventQueue* queue_;
  Ports ports_;
  std::optional<Node> node_;
  int life_ = 0;  // counts starts and ends: timers of another life do nothing
  double clock_offset_s_ = 0.0;
};

}  // namespace sylph_rehearsal
