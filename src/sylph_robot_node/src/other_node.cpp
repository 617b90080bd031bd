#include "sylph_robot_node/other_node.hpp"

#include <XmlRpcClient.h>
#include <XmlRpcDispatch.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/names.h>
#include <ros/network.h>
#include <ros/this_node.h>

#include <chrono>
#include <string>
#include <thread>

#include "sylph_ros/topics.hpp"

namespace sylph_robot_node {
namespace {

constexpr double kAnswer_s = 1.0;
constexpr std::chrono::seconds kPoll{1};

/// Where the master last heard of a node of this name, which may be gone; empty: it never did.
std::string uriOfName() {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = request[1] = ros::this_node::getName();
  const bool is_known = ros::master::execute("lookupNode", request, response, uri, true);
  return is_known ? static_cast<std::string>(uri) : "";
}

/// Whether a robot's node answers there. Another process may have got the port of one that is gone,
/// so it must publish this robot's reports.
bool isRobotNode(const std::string& uri) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) {
    return false;
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue request;
  request[0] = ros::this_node::getName();
  XmlRpc::XmlRpcValue response;
  // Not execute(), which waits for a computer that is switched off as long as TCP does.
  XmlRpc::XmlRpcDispatch dispatch;
  if (!client.executeNonBlock("getPublications", request)) {
    return false;
  }
  dispatch.addSource(&client,
                     XmlRpc::XmlRpcDispatch::WritableEvent | XmlRpc::XmlRpcDispatch::Exception);
  dispatch.work(kAnswer_s);
  const bool has_answered = client.executeCheckDone(response);
  dispatch.removeSource(&client);
  if (!has_answered || client.isFault() || response.getType() != XmlRpc::XmlRpcValue::TypeArray ||
      response.size() != 3) {
    return false;
  }
  const std::string report =
      ros::names::append(ros::this_node::getNamespace(), sylph_ros::kTaskReportTopic);
  for (int i = 0; i < response[2].size(); ++i) {
    if (static_cast<std::string>(response[2][i][0]) == report) {
      return true;
    }
  }
  return false;
}

}  // namespace

void waitForOtherNode() {
  std::string told;
  for (std::string uri = uriOfName(); !uri.empty() && isRobotNode(uri); uri = uriOfName()) {
    if (uri != told) {
      ROS_WARN("%s already runs at %s: this node waits until that has ended",
               ros::this_node::getName().c_str(), uri.c_str());
      told = uri;
    }
    std::this_thread::sleep_for(kPoll);
  }
}

}  // namespace sylph_robot_node
