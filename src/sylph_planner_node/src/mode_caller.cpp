#include "sylph_planner_node/mode_caller.hpp"

#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <chrono>

#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

std::string callTrigger(const std::string& service) {
  std_srvs::Trigger trigger;
  if (!ros::service::call(service, trigger)) {
    return service + ": no answer";
  }
  return trigger.response.success != 0 ? std::string() : service + ": " + trigger.response.message;
}

}  // namespace

void ModeCaller::pause() {
  call(sylph_ros::kPauseService);
}

void ModeCaller::resume() {
  call(sylph_ros::kResumeService);
}

std::optional<std::string> ModeCaller::takeError() {
  if (!answer_.valid() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return std::nullopt;
  }
  const std::string error = answer_.get();
  return error.empty() ? std::nullopt : std::make_optional(error);
}

void ModeCaller::call(const std::string& service) {
  // An answer that has not come yet is waited for here: the order of calls is kept.
  answer_ = std::async(std::launch::async, callTrigger, nh_.resolveName(service));
}

}  // namespace sylph_planner_node
