#include "sylph_core/control/robot_reporter.hpp"

namespace sylph {

std::optional<RobotReport> RobotReporter::offer(const RobotReport& report, double now_s) {
  // What the central node acts on goes out at once; the rest may wait for the period.
  const bool is_due = !sent_s_ || now_s - *sent_s_ >= period_s_;
  if (!is_due && tellTheSame(report, last_)) {
    return std::nullopt;
  }
  const std::uint32_t report_id = last_.report_id + 1;
  last_ = report;
  last_.report_id = report_id;
  sent_s_ = now_s;
  return last_;
}

}  // namespace sylph
