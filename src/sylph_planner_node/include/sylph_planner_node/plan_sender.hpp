#pragma once

#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/JointAction.h>

#include <cstdint>
#include <vector>

namespace sylph_planner_node {

/// Decides which messages of a plan to publish when: all of them in batches, then, as long as
/// AdgState does not show that all have arrived, all of them again after a while.
class PlanSender {
 public:
  /// @param resend_period_s  pause between two rounds [s], > 0
  PlanSender(std::vector<sylph_msgs::JointAction> messages, double resend_period_s);

  /// The messages to publish now.
  /// @param now_s  steady time [s]
  std::vector<sylph_msgs::JointAction> due(double now_s);

  /// Whether the central node has all of the plan.
  bool hasArrived(const sylph_msgs::AdgState& state) const;

  std::uint32_t planId() const { return messages_.front().plan_id; }
  std::uint32_t steps() const { return messages_.front().steps; }

  /// Messages in one batch. It keeps a long plan from flooding the connection.
  static constexpr std::size_t kBatch = 100;

 private:
  std::vector<sylph_msgs::JointAction> messages_;
  double resend_period_s_;
  std::size_t next_ = 0;
  double round_ended_s_ = 0.0;
};

}  // namespace sylph_planner_node
