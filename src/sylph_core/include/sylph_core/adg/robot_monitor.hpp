#pragma once

#include <optional>
#include <string>
#include <utility>

#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/execution/robot_report.hpp"

namespace sylph {

/// Watches over one robot: sorts out late reports, tells whether it is silent, blind or stuck.
class RobotMonitor {
 public:
  explicit RobotMonitor(ExecutionLimits limits) : limits_(std::move(limits)) {}

  /// Takes a report unless it is late: not newer than the last one by stamp and id, while the robot
  /// is not silent.
  /// @param now_s  steady time [s]
  /// @return whether it is news
  bool accept(const RobotReport& report, double now_s);

  /// Looks at the clock.
  /// @param should_move  whether it has a task that it may carry out
  /// @return whether the condition has changed
  bool update(bool should_move, double now_s);
  /// Tells that a task was done.
  void noteProgress(double now_s) { progress_s_ = now_s; }

  /// The robot is out of the mission until rejoin(); its watchdogs rest.
  void setLost() { condition_ = RobotCondition::Lost; }
  /// Takes a robot that was lost back in.
  void rejoin() {
    condition_ = RobotCondition::Ok;
    trouble_since_s_.reset();
  }
  bool isLost() const { return condition_ == RobotCondition::Lost; }

  RobotCondition condition() const { return condition_; }
  /// One line: what is wrong, empty if nothing is.
  std::string trouble(double now_s) const;
  /// Since when something has been wrong [s]; nothing if nothing is.
  std::optional<double> troubleSince() const { return trouble_since_s_; }

  /// The last report, with the last pose that was known; nothing if none has come.
  const std::optional<RobotReport>& report() const { return report_; }
  /// Whether a report came within `silent_after_s`.
  bool isHeard(double now_s) const {
    return report_ && now_s - received_s_ <= limits_.silent_after_s;
  }

 private:
  RobotCondition judge(bool should_move, double now_s);

  ExecutionLimits limits_;
  RobotCondition condition_ = RobotCondition::Ok;
  std::optional<RobotReport> report_;
  std::optional<double> watched_since_s_;
  double received_s_ = 0.0;
  double progress_s_ = 0.0;
  Point progress_at_;
  std::optional<double> trouble_since_s_;
};

}  // namespace sylph
