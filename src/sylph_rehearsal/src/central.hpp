#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/adg/execution.hpp"
#include "sylph_core/adg/run_record.hpp"
#include "sylph_core/control/robot_controller.hpp"
#include "sylph_core/execution/adg_state.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_rehearsal/event_queue.hpp"

namespace sylph_rehearsal {

/// The central node. Its event log outlives it; everything else is lost when it ends.
class Central {
 public:
  struct Ports {
    std::function<void(const sylph::TaskOrder&)> task;
    std::function<void(const sylph::CentralState&)> central_state;  ///< to the robots
    std::function<void(const sylph::AdgState&)> adg_state;          ///< to the planner
    std::function<void(const sylph::ExecutionEvent&)> event;  ///< told to nobody but the oracle
  };

  /// @param experiment, queue  have to outlive it
  Central(const sylph::Experiment& experiment, sylph::ExecutionLimits limits,
          double heartbeat_period_s, EventQueue& queue, Ports ports);

  /// Starts, and goes on from its log.
  void start();
  void crash();
  /// By the operator, into a new run folder: it knows nothing of the run so far.
  void launchAnew();
  bool isUp() const { return execution_.has_value(); }

  void onPlan(const sylph::MissionPlan& plan);
  void onReport(int robot, const sylph::RobotReport& report);
  /// @param reason  what the separation monitor says
  void onEmergencyStop(bool is_pressed, const std::string& reason);
  /// @return false if the emergency stop is still pressed, or the node is down
  bool setMode(sylph::ExecutionMode mode, const std::string& reason);
  void declareLost(int robot, const std::string& reason);

  /// Whether the plan that is carried out moves a robot still.
  bool hasTasksToCome(int robot) const;
  /// Nothing while it is down.
  const sylph::Execution* execution() const { return execution_ ? &*execution_ : nullptr; }
  const std::vector<std::string>& log() const { return log_; }
  /// Of the run so far.
  sylph::RunRecord& record() { return record_; }

 private:
  void tick(int life);
  void flush();
  void publishCentralState();

  const sylph::Experiment* experiment_;
  sylph::ExecutionLimits limits_;
  double heartbeat_period_s_;
  EventQueue* queue_;
  Ports ports_;
  std::vector<std::string> names_;
  std::vector<std::string> log_;
  std::optional<sylph::Execution> execution_;
  sylph::RunRecord record_;
  bool has_changed_ = true;  // since the last AdgState
  double state_sent_s_ = 0.0;
  int life_ = 0;
};

}  // namespace sylph_rehearsal
