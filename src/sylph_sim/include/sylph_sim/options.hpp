#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_natnet/udp_socket.hpp"
#include "sylph_natnet/version.hpp"
#include "sylph_ros/parameter_reader.hpp"
#include "sylph_sim/conversions.hpp"
#include "sylph_sim/lock_step_host.hpp"
#include "sylph_sim/simulation.hpp"

namespace sylph_sim {

/// How frames travel to the bridge.
struct NatNetOptions {
  sylph_natnet::Version version{4, 1};
  sylph_natnet::Ipv4Address address{{127, 0, 0, 1}};
  int command_port = 1510;  ///< 0: any free one
  int data_port = 1511;     ///< 0: any free one
  bool multicast = false;   ///< to the group, else to each client by itself
  sylph_natnet::Ipv4Address multicast_group{{239, 255, 42, 99}};
  UpAxis up_axis = UpAxis::Z;
  double body_height_m = 0.12;  ///< of the rigid bodies above the floor
};

/// The parameters of the simulator.
struct Options {
  SimulationOptions simulation;
  NatNetOptions natnet;
  LockStepOptions lock_step;
  double clock_period_s = 0.01;             ///< simulated time between two /clock messages
  double clock_wall_rate_limit_hz = 400.0;  ///< /clock messages a wall second at most
  double truth_rate_hz = 20.0;              ///< a simulated second
};

/// Meaning and bounds of each.
/// @throws std::runtime_error naming the parameter, its value and what is allowed
Options readOptions(sylph_ros::ParameterReader& reader);

/// The fault script, parameter `faults`: a list of {kind, robots, at_s, duration_s, value}, of
/// which only `kind` must be given.
/// @throws std::runtime_error naming the entry, the field and what is allowed
std::vector<Fault> loadFaults(const ros::NodeHandle& private_nh,
                              const sylph::Experiment& experiment);

}  // namespace sylph_sim
