#include "sylph_ros/trigger_command.hpp"

#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <chrono>
#include <cstdlib>
#include <future>
#include <iostream>

namespace sylph_ros {
namespace {

constexpr double kServiceWait_s = 5.0;  ///< wall time for the node to appear
constexpr int kAnswerWait_s = 5;        ///< wall time for its answer

int fail(const TriggerCommand& command, const std::string& message) {
  std::cerr << command.name << ": " << message << std::endl;
  return EXIT_FAILURE;
}

bool isServed(const std::string& service) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kServiceWait_s);
  while (!ros::service::exists(service, false) && ros::WallTime::now() < deadline) {
    ros::WallDuration(0.05).sleep();
  }
  return ros::service::exists(service, false);
}

}  // namespace

int runTriggerCommand(const TriggerCommand& command) {
  if (!ros::master::check()) {
    return fail(command,
                "no ROS master at " + ros::master::getURI() + ": is ROS_MASTER_URI right?");
  }
  const std::string service = ros::NodeHandle().resolveName(command.service);
  if (!isServed(service)) {
    return fail(command, "nobody serves " + service + ": no " + command.server);
  }
  std_srvs::Trigger trigger;
  auto answer =
      std::async(std::launch::async, [&] { return ros::service::call(service, trigger); });
  if (answer.wait_for(std::chrono::seconds(kAnswerWait_s)) != std::future_status::ready) {
    std::_Exit(fail(command, service + " does not answer: " + command.if_silent));
  }
  if (!answer.get()) {
    return fail(command, service + " did not answer: " + command.if_silent);
  }
  if (trigger.response.success == 0) {
    return fail(command, trigger.response.message);
  }
  std::cout << trigger.response.message << std::endl;
  return EXIT_SUCCESS;
}

}  // namespace sylph_ros
