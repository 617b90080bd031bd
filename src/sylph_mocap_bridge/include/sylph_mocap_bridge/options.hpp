#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_mocap_bridge/frame_stamper.hpp"
#include "sylph_mocap_bridge/robot_publishers.hpp"
#include "sylph_mocap_bridge/robot_tracks.hpp"
#include "sylph_natnet/client.hpp"
#include "sylph_ros/parameter_reader.hpp"

namespace sylph_mocap_bridge {

/// Where poses come from.
enum class Input { NatNet, PoseTopics };

/// Parameters of mocap_bridge.
struct Options {
  Input input = Input::NatNet;
  sylph_natnet::ClientOptions client;
  /// {rigid_body} and {robot} stand for the names.
  std::string pose_topic = "/vrpn_client_node/{rigid_body}/pose";
  StampPolicy stamp = StampPolicy::ClockSync;
  TracksOptions tracks;
  PublishRates rates;
};

/// Meaning and bounds of each.
/// @param robots  names, for what is set robot by robot
/// @throws std::runtime_error naming the parameter, its value and what is allowed
Options readOptions(sylph_ros::ParameterReader& reader, const std::vector<std::string>& robots);

/// @throws std::runtime_error as readOptions(), and on a parameter that is unknown
Options loadOptions(const ros::NodeHandle& private_nh, const sylph::Experiment& experiment);

}  // namespace sylph_mocap_bridge
