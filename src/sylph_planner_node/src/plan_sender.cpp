#include "sylph_planner_node/plan_sender.hpp"

#include <algorithm>
#include <stdexcept>

namespace sylph_planner_node {

PlanSender::PlanSender(std::vector<sylph_msgs::JointAction> messages, double resend_period_s)
    : messages_(std::move(messages)), resend_period_s_(resend_period_s) {
  if (messages_.empty()) {
    throw std::invalid_argument("a plan has at least one message");
  }
}

std::vector<sylph_msgs::JointAction> PlanSender::due(double now_s) {
  if (next_ == messages_.size()) {
    if (now_s - round_ended_s_ < resend_period_s_) {
      return {};
    }
    next_ = 0;
  }
  const std::size_t end = std::min(next_ + kBatch, messages_.size());
  std::vector<sylph_msgs::JointAction> batch(messages_.begin() + static_cast<std::ptrdiff_t>(next_),
                                             messages_.begin() + static_cast<std::ptrdiff_t>(end));
  next_ = end;
  round_ended_s_ = now_s;
  return batch;
}

bool PlanSender::hasArrived(const sylph_msgs::AdgState& state) const {
  return state.plan_id == planId() && state.steps_received >= steps() &&
         state.phase != sylph_msgs::AdgState::RECEIVING;
}

}  // namespace sylph_planner_node
