#include "sylph_ros/reachability.hpp"

#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/node_handle.h>
#include <ros/xmlrpc_manager.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/TaskReport.h>

namespace sylph_ros {
namespace {

constexpr double kTimeout = 0.5;

/// Registers a publisher as a node on another computer does.
void registerPublisher(const std::string& method, const std::string& node, const std::string& topic,
                       const std::string& uri) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue payload;
  request[0] = node;
  request[1] = topic;
  if (method == "registerPublisher") {
    request[2] = "sylph_msgs/AdgState";
    request[3] = uri;
  } else {
    request[2] = uri;
  }
  ASSERT_TRUE(ros::master::execute(method, request, response, payload, false));
}

TEST(ReachabilityTest, ANameThatThisComputerDoesNotKnowIsNamedWithItsRemedy) {
  EXPECT_EQ(
      "/cf1/robot is registered at http://cf1.invalid:4211/, but this computer knows no address of "
      "'cf1.invalid': set ROS_IP where /cf1/robot runs, or name cf1.invalid in /etc/hosts here",
      whyUnreachable("/cf1/robot", "http://cf1.invalid:4211/", kTimeout));
}

TEST(ReachabilityTest, ANodeThatIsGoneDoesNotAnswer) {
  // Port 1 is nobody's on a computer that runs tests.
  const std::string why = whyUnreachable("/cf1/robot", "http://127.0.0.1:1/", kTimeout);
  EXPECT_EQ(0U, why.find("/cf1/robot does not answer at http://127.0.0.1:1/ (Connection refused)"))
      << why;
}

TEST(ReachabilityTest, WhatIsNoAddressIsSaid) {
  EXPECT_EQ("/cf1/robot is registered at 'rosrpc', which is no address",
            whyUnreachable("/cf1/robot", "rosrpc", kTimeout));
}

TEST(ReachabilityTest, ListsRobotsThatReportInAnotherNamespace) {
  ros::NodeHandle nh;
  const ros::Publisher here = nh.advertise<sylph_msgs::TaskReport>("/cf1/task_report", 1);
  const ros::Publisher there = nh.advertise<sylph_msgs::TaskReport>("/hall/cf2/task_report", 1);
  const ros::Publisher both = nh.advertise<sylph_msgs::TaskReport>("/hall/cf1/task_report", 1);
  const ros::Publisher other = nh.advertise<sylph_msgs::AdgState>("/hall/cf3/task_report", 1);
  EXPECT_EQ(std::vector<std::string>{"cf2 reports on /hall/cf2/task_report, and is waited for on "
                                     "/cf2/task_report: is ROS_NAMESPACE set on one side only?"},
            robotsElsewhere("/", {"cf1", "cf2", "cf3"}));
  EXPECT_TRUE(robotsElsewhere("/hall", {"cf1", "cf2"}).empty());
}

TEST(ReachabilityTest, ListsPublishersOfTheFleetThatCannotBeReached) {
  ros::NodeHandle nh("/lab");
  const ros::Publisher here = nh.advertise<sylph_msgs::AdgState>("here", 1);
  const std::string lost = "http://cf1.invalid:4211/";
  registerPublisher("registerPublisher", "/lab/cf1/robot", "/lab/cf1/task_report", lost);
  registerPublisher("registerPublisher", "/other/cf9/robot", "/other/cf9/task_report", lost);
  const std::vector<std::string> lines = unreachablePublishers("/lab", kTimeout);
  ASSERT_EQ(1U, lines.size());
  EXPECT_EQ(0U, lines.front().find("/lab/cf1/robot is registered at " + lost)) << lines.front();
  EXPECT_EQ(2U, unreachablePublishers("/", kTimeout).size());
  registerPublisher("unregisterPublisher", "/lab/cf1/robot", "/lab/cf1/task_report", lost);
  registerPublisher("unregisterPublisher", "/other/cf9/robot", "/other/cf9/task_report", lost);
  EXPECT_TRUE(unreachablePublishers("/lab", kTimeout).empty());
}

}  // namespace
}  // namespace sylph_ros
