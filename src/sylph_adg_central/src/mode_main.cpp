#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <cstdlib>
#include <future>
#include <iostream>
#include <string>

namespace {

constexpr char kMode[] = SYLPH_MODE;  ///< the service: pause, stop or resume
constexpr double kServiceWait = 5.0;  ///< wall time for the central node to appear [s]
constexpr int kAnswerWait = 5;        ///< wall time for its answer [s]

int fail(const std::string& message) {
  std::cerr << "sylph_" << kMode << ": " << message << "\n";
  return EXIT_FAILURE;
}

}  // namespace

/// Asks the central node of the fleet in the present namespace for a mode, by a service that needs
/// no Python on this computer. Exit status: 0 it is done, 1 with one line why not.
int main(int argc, char** argv) {
  ros::init(argc, argv, std::string("sylph_") + kMode, ros::init_options::AnonymousName);
  if (argc != 1) {
    return fail("takes no arguments; the fleet is that of ROS_NAMESPACE or __ns:=");
  }
  if (!ros::master::check()) {
    return fail("no ROS master at " + ros::master::getURI() + ": is ROS_MASTER_URI right?");
  }
  const ros::NodeHandle nh("sylph");
  const std::string service = nh.resolveName(kMode);
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kServiceWait);
  while (!ros::service::exists(service, false) && ros::WallTime::now() < deadline) {
    ros::WallDuration(0.05).sleep();
  }
  if (!ros::service::exists(service, false)) {
    return fail("nobody serves " + service + ": no central node in this namespace");
  }
  std_srvs::Trigger trigger;
  auto answer =
      std::async(std::launch::async, [&] { return ros::service::call(service, trigger); });
  if (answer.wait_for(std::chrono::seconds(kAnswerWait)) != std::future_status::ready) {
    std::_Exit(fail(service + " does not answer: cut the robots' power if they move"));
  }
  if (!answer.get()) {
    return fail(service + " did not answer: cut the robots' power if they move");
  }
  if (trigger.response.success == 0) {
    return fail(trigger.response.message);
  }
  std::cout << trigger.response.message << std::endl;
  return EXIT_SUCCESS;
}
