#include "sylph_mocap_bridge/options.hpp"

#include <limits>

namespace sylph_mocap_bridge {
namespace {

using sylph_ros::ParameterReader;

void readPort(ParameterReader& reader, const char* name, std::uint16_t& port, const char* meaning) {
  int number = port;
  reader.read(name, number, {1.0, std::numeric_limits<std::uint16_t>::max()}, meaning);
  port = static_cast<std::uint16_t>(number);
}

void readClient(ParameterReader& reader, sylph_natnet::ClientOptions& client) {
  using sylph_natnet::addressFromString;
  using sylph_natnet::toString;
  reader.readParsed("server_address", client.server, toString(client.server), addressFromString,
                    "computer that runs Motive; the simulator is on this one");
  reader.readParsed(
      "local_interface", client.local_interface, "", addressFromString,
      "this computer's address in the cameras' network; empty: that of the route to the "
      "server");
  readPort(reader, "command_port", client.command_port, "of the server");
  readPort(reader, "data_port", client.data_port, "of the multicast group; unicast needs none");
  reader.readChoice<bool>("transport", client.multicast, {{"unicast", false}, {"multicast", true}},
                          "as the server is set");
  reader.readParsed("multicast_group", client.multicast_group, toString(client.multicast_group),
                    addressFromString, "224.0.0.0 ... 239.255.255.255, as the server is set");
  if (!sylph_natnet::isMulticast(client.multicast_group)) {
    throw reader.error("multicast_group", "must be in 224.0.0.0 ... 239.255.255.255");
  }
  reader.readParsed(
      "bitstream", client.bitstream, "", sylph_natnet::versionFromString,
      "read frames as this NatNet version (3.0; `\"2.10\"` in quotes, as a number it is 2.1); "
      "empty: as the server tells");
}

sylph::Pose2d readPose(ParameterReader reader, const char* where) {
  const sylph::Range far{-1000.0, 1000.0};
  sylph::Pose2d pose;
  reader.read("x_m", pose.x_m, far, where);
  reader.read("y_m", pose.y_m, far, "its y coordinate");
  reader.read("yaw_rad", pose.yaw_rad, far, "its heading");
  return pose;
}

void readTracks(ParameterReader& reader, const std::vector<std::string>& robots,
                TracksOptions& tracks) {
  const sylph::Range positive = sylph::Range::positive();
  reader.readChoice<UpAxis>("up_axis", tracks.up_axis, {{"y", UpAxis::Y}, {"z", UpAxis::Z}},
                            "\"Up Axis\" in Motive's streaming settings, whose default is y; of "
                            "pose topics too");
  tracks.map_from_mocap =
      readPose(reader.group("map_from_mocap"), "x coordinate on the map of the cameras' origin");
  const ParameterReader bodies = reader.group("body_from_robot");
  for (const std::string& robot : robots) {
    tracks.body_from_robot.push_back(
        readPose(bodies.group(robot), "x coordinate of the robot's centre in its rigid body"));
  }
  reader.read("largest_age_s", tracks.largest_age_s, positive,
              "poses with a stamp that is older, or as far ahead, are not published");
  reader.read("frozen_limit_s", tracks.frozen_limit_s, {0.0, 1000.0},
              "a pose that keeps each of its bits for longer is not published, since cameras have "
              "noise; 0: never mind");
  reader.read("position_sigma_m", tracks.tracker.position_sigma_m, positive,
              "noise of a measured position");
  reader.read("heading_sigma_rad", tracks.tracker.heading_sigma_rad, positive,
              "noise of a measured heading");
  reader.read("acceleration_sigma_mps2", tracks.tracker.acceleration_sigma_mps2, positive,
              "how wildly robots speed up: larger follows faster, with more noise");
  reader.read("acceleration_sigma_radps2", tracks.tracker.acceleration_sigma_radps2, positive,
              "the same for their turning");
}

void readRates(ParameterReader& reader, PublishRates& rates) {
  const sylph::Range range{0.0, 10'000.0};
  reader.read("pose_rate_hz", rates.pose_hz, range, "by the poses' stamps; 0: each frame");
  reader.read("odom_rate_hz", rates.odom_hz, range, "the same for `odom`");
  reader.read("tf_rate_hz", rates.tf_hz, range, "the same for `/tf`");
}

}  // namespace

Options readOptions(ParameterReader& reader, const std::vector<std::string>& robots) {
  Options options;
  reader.readChoice<Input>("input", options.input,
                           {{"natnet", Input::NatNet}, {"pose_topics", Input::PoseTopics}},
                           "OptiTrack's own stream, or PoseStamped topics of another driver");
  readClient(reader, options.client);
  reader.read(
      "pose_topic", options.pose_topic,
      "of the other driver; `{rigid_body}` and `{robot}` stand for the names without what no ROS "
      "name may have, as vrpn_client_ros writes them: `Rigid Body 1` is `RigidBody1`");
  if (options.pose_topic.find("{r") == std::string::npos) {
    throw reader.error("pose_topic", "must contain {rigid_body} or {robot}");
  }
  reader.readChoice<StampPolicy>("stamp", options.stamp,
                                 {{"receive", StampPolicy::Receive},
                                  {"latency_compensated", StampPolicy::LatencyCompensated},
                                  {"clock_sync", StampPolicy::ClockSync}},
                                 "when it came, that less the server's own latency, or when the "
                                 "cameras saw it");
  readTracks(reader, robots, options.tracks);
  readRates(reader, options.rates);
  sylph_ros::readDiagnosticPeriod(reader);
  return options;
}

Options loadOptions(const ros::NodeHandle& private_nh, const sylph::Experiment& experiment) {
  return sylph_ros::readStrictly(private_nh, [&](ParameterReader& reader) {
    return readOptions(reader, namesOf(experiment));
  });
}

}  // namespace sylph_mocap_bridge
