#pragma once

#include <ros/node_handle.h>

#include <string>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_mocap_bridge/frame_stamper.hpp"
#include "sylph_mocap_bridge/robot_publishers.hpp"
#include "sylph_mocap_bridge/robot_tracks.hpp"
#include "sylph_natnet/client.hpp"

namespace sylph_mocap_bridge {

/// Where poses come from.
enum class Input { NatNet, PoseTopics };

/// Parameters; config/mocap_bridge.yaml has each with its default and meaning.
struct Options {
  Input input = Input::NatNet;
  sylph_natnet::ClientOptions client;
  /// {rigid_body} and {robot} stand for the names.
  std::string pose_topic = "/vrpn_client_node/{rigid_body}/pose";
  StampPolicy stamp = StampPolicy::ClockSync;
  TracksOptions tracks;
  PublishRates rates;
};

/// @throws std::runtime_error naming the parameter, its value and what is allowed
Options loadOptions(const ros::NodeHandle& private_nh, const sylph::Experiment& experiment);

}  // namespace sylph_mocap_bridge
