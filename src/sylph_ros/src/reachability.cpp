#include "sylph_ros/reachability.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <ros/master.h>
#include <ros/names.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sylph_msgs/TaskReport.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <set>

#include "sylph_ros/topics.hpp"

namespace sylph_ros {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

/// A socket that is closed in the end.
class Socket {
 public:
  explicit Socket(const addrinfo& address)
      : descriptor_(socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK, 0)) {}
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() {
    if (descriptor_ >= 0) {
      close(descriptor_);
    }
  }
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

/// @return 0, or why there is no connection (errno)
int connectTo(const addrinfo& address, double timeout_s) {
  const Socket connection(address);
  if (connection.get() < 0) {
    return errno;
  }
  if (connect(connection.get(), address.ai_addr, address.ai_addrlen) == 0) {
    return 0;
  }
  if (errno != EINPROGRESS) {
    return errno;
  }
  pollfd ready{connection.get(), POLLOUT, 0};
  if (poll(&ready, 1, static_cast<int>(1e3 * timeout_s)) <= 0) {
    return ETIMEDOUT;
  }
  int error = 0;
  socklen_t size = sizeof(error);
  getsockopt(connection.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

bool isBelow(const std::string& topic, const std::string& ns) {
  return ns == "/" || topic.rfind(ns + "/", 0) == 0;
}

std::set<std::string> publishersBelow(const std::string& ns) {
  std::set<std::string> nodes;
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) {
    return nodes;
  }
  XmlRpc::XmlRpcValue& publishers = state[0];
  // NOLINTNEXTLINE(modernize-loop-convert): an array of XmlRpc has no iterators.
  for (int topic = 0; topic < publishers.size(); ++topic) {
    if (isBelow(publishers[topic][0], ns)) {
      XmlRpc::XmlRpcValue& names = publishers[topic][1];
      // NOLINTNEXTLINE(modernize-loop-convert): as above
      for (int node = 0; node < names.size(); ++node) {
        nodes.insert(static_cast<std::string>(names[node]));
      }
    }
  }
  return nodes;
}

}  // namespace

std::string whyUnreachable(const std::string& node, const std::string& uri, double timeout_s) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) {
    return node + " is registered at '" + uri + "', which is no address";
  }
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) {
    return node + " is registered at " + uri + ", but this computer knows no address of '" + host +
           "': set ROS_IP where " + node + " runs, or name " + host + " in /etc/hosts here";
  }
  const Addresses addresses(found, &freeaddrinfo);
  int error = 0;
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    error = connectTo(*address, timeout_s);
    if (error == 0) {
      return "";
    }
  }
  return node + " does not answer at " + uri + " (" + std::strerror(error) +
         "): it has died, ROS_IP where it runs is wrong, or a firewall is between";
}

std::vector<std::string> unreachablePublishers(const std::string& ns, double timeout_s) {
  std::vector<std::string> lines;
  for (const std::string& node : publishersBelow(ns)) {
    XmlRpc::XmlRpcValue request;
    XmlRpc::XmlRpcValue response;
    XmlRpc::XmlRpcValue uri;
    request[0] = ros::this_node::getName();
    request[1] = node;
    if (ros::master::execute("lookupNode", request, response, uri, false)) {
      const std::string line = whyUnreachable(node, static_cast<std::string>(uri), timeout_s);
      if (!line.empty()) {
        lines.push_back(line);
      }
    }
  }
  return lines;
}

std::vector<std::string> robotsElsewhere(const std::string& ns,
                                         const std::vector<std::string>& robots) {
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) {
    return {};
  }
  std::vector<std::string> lines;
  for (const std::string& robot : robots) {
    const std::string name = ros::names::append("/" + robot, kTaskReportTopic);
    const std::string wanted = ros::names::append(ns, name);
    std::string found;
    for (const ros::master::TopicInfo& topic : topics) {
      if (topic.name == wanted) {
        found.clear();
        break;
      }
      const bool ends_with =
          topic.name.size() >= name.size() &&
          topic.name.compare(topic.name.size() - name.size(), name.size(), name) == 0;
      if (ends_with && topic.datatype == ros::message_traits::datatype<sylph_msgs::TaskReport>()) {
        found = topic.name;
      }
    }
    if (!found.empty()) {
      lines.push_back(robot + " reports on " + found + ", and is waited for on " + wanted +
                      ": is ROS_NAMESPACE set on one side only?");
    }
  }
  return lines;
}

}  // namespace sylph_ros
