#include "sylph_mocap_bridge/options.hpp"

#include <XmlRpcValue.h>
#include <ros/param.h>

#include <limits>
#include <map>
#include <stdexcept>

#include "sylph_ros/parameters.hpp"

namespace sylph_mocap_bridge {
namespace {

using sylph_ros::read;

/// Bound of what has none by nature [m, rad, s].
constexpr double kFar = 1000.0;

[[noreturn]] void refuse(const ros::NodeHandle& nh, const std::string& name,
                         const std::string& what) {
  throw std::runtime_error("parameter " + nh.resolveName(name) + ": " + what);
}

/// One of a few words.
template <typename Value>
void readChoice(const ros::NodeHandle& nh, const std::string& name,
                const std::map<std::string, Value>& choices, Value& value) {
  std::string word;
  read(nh, name, word);
  if (word.empty() && !nh.hasParam(name)) {
    return;
  }
  const auto found = choices.find(word);
  if (found == choices.end()) {
    std::string allowed;
    for (const auto& [choice, meaning] : choices) {
      allowed += (allowed.empty() ? "" : ", ") + choice;
    }
    refuse(nh, name, "is '" + word + "': must be one of " + allowed);
  }
  value = found->second;
}

void readPort(const ros::NodeHandle& nh, const std::string& name, std::uint16_t& port) {
  int number = port;
  read(nh, name, number);
  sylph_ros::requireInRange(nh, name, number, 1, std::numeric_limits<std::uint16_t>::max());
  port = static_cast<std::uint16_t>(number);
}

/// @param value  left as it is if the text is empty
void readAddress(const ros::NodeHandle& nh, const std::string& name,
                 sylph_natnet::Ipv4Address& value) {
  std::string text;
  read(nh, name, text);
  if (text.empty()) {
    return;
  }
  try {
    value = sylph_natnet::addressFromString(text);
  } catch (const std::invalid_argument& error) {
    refuse(nh, name, error.what());
  }
}

void readClient(const ros::NodeHandle& nh, sylph_natnet::ClientOptions& client) {
  readAddress(nh, "server_address", client.server);
  readAddress(nh, "local_interface", client.local_interface);
  readAddress(nh, "multicast_group", client.multicast_group);
  if (!sylph_natnet::isMulticast(client.multicast_group)) {
    refuse(nh, "multicast_group",
           "is " + sylph_natnet::toString(client.multicast_group) +
               ": must be in 224.0.0.0 ... 239.255.255.255");
  }
  readPort(nh, "command_port", client.command_port);
  readPort(nh, "data_port", client.data_port);
  readChoice(nh, "transport", {{"unicast", false}, {"multicast", true}}, client.multicast);
  std::string bitstream;
  read(nh, "bitstream", bitstream);
  if (!bitstream.empty()) {
    try {
      client.bitstream = sylph_natnet::versionFromString(bitstream);
    } catch (const std::invalid_argument& error) {
      refuse(nh, "bitstream", error.what());
    }
  }
}

/// @throws std::runtime_error if the parameter is set and has no parameters below it
void requireGroup(const ros::NodeHandle& group) {
  XmlRpc::XmlRpcValue value;
  if (ros::param::get(group.getNamespace(), value) &&
      value.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    throw std::runtime_error("parameter " + group.getNamespace() +
                             ": must be a group of parameters");
  }
}

sylph::Pose2d readPose(const ros::NodeHandle& nh) {
  requireGroup(nh);
  sylph_ros::requireKnown(nh, {"x_m", "y_m", "yaw_rad"});
  sylph::Pose2d pose;
  for (const auto& [name, value] : {std::pair<const char*, double*>{"x_m", &pose.x_m},
                                    {"y_m", &pose.y_m},
                                    {"yaw_rad", &pose.yaw_rad}}) {
    read(nh, name, *value);
    sylph_ros::requireInRange(nh, name, *value, -kFar, kFar);
  }
  return pose;
}

void readTracks(const ros::NodeHandle& nh, const sylph::Experiment& experiment,
                TracksOptions& tracks) {
  readChoice(nh, "up_axis", {{"y", UpAxis::Y}, {"z", UpAxis::Z}}, tracks.up_axis);
  tracks.map_from_mocap = readPose(ros::NodeHandle(nh, "map_from_mocap"));
  const ros::NodeHandle bodies(nh, "body_from_robot");
  requireGroup(bodies);
  std::vector<std::string> names;
  for (const sylph::RobotSpec& robot : experiment.robots) {
    names.push_back(robot.name);
    tracks.body_from_robot.push_back(readPose(ros::NodeHandle(bodies, robot.name)));
  }
  sylph_ros::requireKnown(bodies, names);
  const auto readPositive = [&nh](const char* name, double& value) {
    read(nh, name, value);
    sylph_ros::requirePositive(nh, name, value);
  };
  readPositive("largest_age_s", tracks.largest_age_s);
  read(nh, "frozen_limit_s", tracks.frozen_limit_s);
  sylph_ros::requireInRange(nh, "frozen_limit_s", tracks.frozen_limit_s, 0.0, kFar);
  readPositive("position_sigma_m", tracks.tracker.position_sigma_m);
  readPositive("heading_sigma_rad", tracks.tracker.heading_sigma_rad);
  readPositive("acceleration_sigma_mps2", tracks.tracker.acceleration_sigma_mps2);
  readPositive("acceleration_sigma_radps2", tracks.tracker.acceleration_sigma_radps2);
}

}  // namespace

Options loadOptions(const ros::NodeHandle& private_nh, const sylph::Experiment& experiment) {
  sylph_ros::requireKnown(private_nh, {"input",
                                       "server_address",
                                       "local_interface",
                                       "command_port",
                                       "data_port",
                                       "transport",
                                       "multicast_group",
                                       "bitstream",
                                       "pose_topic",
                                       "stamp",
                                       "up_axis",
                                       "map_from_mocap",
                                       "body_from_robot",
                                       "largest_age_s",
                                       "frozen_limit_s",
                                       "position_sigma_m",
                                       "heading_sigma_rad",
                                       "acceleration_sigma_mps2",
                                       "acceleration_sigma_radps2",
                                       "pose_rate_hz",
                                       "odom_rate_hz",
                                       "tf_rate_hz"});
  Options options;
  readChoice(private_nh, "input", {{"natnet", Input::NatNet}, {"pose_topics", Input::PoseTopics}},
             options.input);
  readClient(private_nh, options.client);
  read(private_nh, "pose_topic", options.pose_topic);
  if (options.pose_topic.find("{r") == std::string::npos) {
    refuse(private_nh, "pose_topic",
           "is '" + options.pose_topic + "': must contain {rigid_body} or {robot}");
  }
  readChoice(private_nh, "stamp",
             {{"receive", StampPolicy::Receive},
              {"latency_compensated", StampPolicy::LatencyCompensated},
              {"clock_sync", StampPolicy::ClockSync}},
             options.stamp);
  readTracks(private_nh, experiment, options.tracks);
  constexpr double kFast = 10'000.0;
  for (const auto& [name, value] :
       {std::pair<const char*, double*>{"pose_rate_hz", &options.rates.pose_hz},
        {"odom_rate_hz", &options.rates.odom_hz},
        {"tf_rate_hz", &options.rates.tf_hz}}) {
    read(private_nh, name, *value);
    sylph_ros::requireInRange(private_nh, name, *value, 0.0, kFast);
  }
  return options;
}

}  // namespace sylph_mocap_bridge
