#pragma once

#include <optional>

#include "sylph_core/execution/robot_report.hpp"

namespace sylph {

/// Decides when a robot tells of itself: at a rate, and at once when others wait for the news.
class RobotReporter {
 public:
  /// @param rate_hz  > 0
  explicit RobotReporter(double rate_hz) : period_s_(1.0 / rate_hz) {}

  /// @param report  as of now, without id
  /// @return the report with its id, if it is to be sent now
  std::optional<RobotReport> offer(const RobotReport& report, double now_s);

  /// The last one that was sent.
  const RobotReport& last() const { return last_; }

 private:
  double period_s_;
  RobotReport last_;
  std::optional<double> sent_s_;
};

}  // namespace sylph
