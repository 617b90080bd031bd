#include "sylph_rviz/trigger_call.hpp"

#include <std_srvs/Trigger.h>

#include <chrono>
#include <utility>

#include "sylph_core/files/range.hpp"

namespace sylph_rviz {

TriggerCall::TriggerCall(const ros::NodeHandle& nh, std::string name, double timeout_s)
    : nh_(nh), name_(std::move(name)), timeout_s_(timeout_s) {}

TriggerCall::~TriggerCall() {
  giveUp();
  if (answer_.valid()) {
    answer_.wait();
  }
}

void TriggerCall::call() {
  if (answer_.valid()) {
    return;
  }
  begun_ = ros::SteadyTime::now();
  is_given_up_ = false;
  answer_ = std::async(std::launch::async, [this] { return callService(); });
}

std::string TriggerCall::takeOutcome() {
  if (!answer_.valid()) {
    return "";
  }
  if (answer_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    return answer_.get();
  }
  if ((ros::SteadyTime::now() - begun_).toSec() > timeout_s_) {
    giveUp();
  }
  return "";
}

std::string TriggerCall::callService() {
  // Only a persistent connection can be dropped while it waits for an answer.
  ros::ServiceClient client = nh_.serviceClient<std_srvs::Trigger>(name_, true);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_given_up_) {
      return name_ + ": given up";
    }
    client_ = client;
  }
  std_srvs::Trigger trigger;
  const bool has_answer = client.isValid() && client.call(trigger);
  const std::lock_guard<std::mutex> lock(mutex_);
  client_ = ros::ServiceClient();
  if (is_given_up_) {
    return name_ + ": no answer for " + sylph::shortNumber(timeout_s_) + " s";
  }
  if (!has_answer) {
    return name_ + ": nobody offers " + nh_.resolveName(name_);
  }
  return name_ + ": " + (trigger.response.success != 0 ? "done" : trigger.response.message);
}

void TriggerCall::giveUp() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_given_up_ = true;
  client_.shutdown();
}

}  // namespace sylph_rviz
