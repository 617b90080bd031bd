#include "sylph_core/adg/robot_monitor.hpp"

#include <tuple>

#include "sylph_core/text/format.hpp"

namespace sylph {

bool RobotMonitor::accept(const RobotReport& report, double now_s) {
  // By stamp first: a node that was started again counts from 1. A clock that was set back shows as
  // silence.
  const bool is_late =
      report_ && isHeard(now_s) &&
      std::tie(report.stamp_s, report.report_id) <= std::tie(report_->stamp_s, report_->report_id);
  if (is_late) {
    return false;
  }
  if (report.pose &&
      (!report_ || distance(position(*report.pose), progress_at_) >= limits_.progress_m)) {
    progress_at_ = position(*report.pose);
    progress_s_ = now_s;
  }
  const std::optional<Pose2d> last_pose = report_ ? report_->pose : std::nullopt;
  report_ = report;
  // For a robot that has become blind the last place is the best guess.
  if (!report_->pose) {
    report_->pose = last_pose;
  }
  received_s_ = now_s;
  return true;
}

RobotCondition RobotMonitor::judge(bool should_move, double now_s) {
  // A robot that has nothing to do, or cannot see, makes no progress and is not stuck.
  if (!should_move || (report_ && report_->state == RobotState::Blind)) {
    progress_s_ = now_s;
  }
  // Silence first: what a silent robot said last is no longer true.
  if (now_s - received_s_ > limits_.silent_after_s) {
    return RobotCondition::Silent;
  }
  if (report_ && report_->state == RobotState::Blind) {
    return RobotCondition::Blind;
  }
  if (now_s - progress_s_ > limits_.stuck_after_s) {
    return RobotCondition::Stuck;
  }
  return RobotCondition::Ok;
}

bool RobotMonitor::update(bool should_move, double now_s) {
  if (!watched_since_s_) {
    watched_since_s_ = now_s;
    // Nobody is late before anybody has listened.
    received_s_ = report_ ? received_s_ : now_s;
    progress_s_ = now_s;
  }
  if (isLost()) {
    return false;
  }
  const RobotCondition before = condition_;
  condition_ = judge(should_move, now_s);
  if (condition_ == RobotCondition::Ok) {
    trouble_since_s_.reset();
  } else if (!trouble_since_s_) {
    trouble_since_s_ = now_s;
  }
  return condition_ != before;
}

std::string RobotMonitor::trouble(double now_s) const {
  const std::string detail =
      report_ && !report_->detail.empty() ? ": " + report_->detail : std::string();
  switch (condition_) {
    case RobotCondition::Ok:
      return {};
    case RobotCondition::Silent:
      return report_ ? "no report for " + format("%.1f s", now_s - received_s_) : "no report yet";
    case RobotCondition::Stuck:
      return "no progress for " + format("%.1f s", now_s - progress_s_) + detail;
    case RobotCondition::Blind:
      return "no good pose" + detail;
    case RobotCondition::Lost:
      return "lost";
  }
  return {};
}

}  // namespace sylph
