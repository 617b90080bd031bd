#include "sylph_sim/options.hpp"

#include <XmlRpcValue.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "sylph_ros/parameters.hpp"

namespace sylph_sim {
namespace {

using XmlRpc::XmlRpcValue;

using NamedValue = std::pair<const char*, double*>;

/// Reads all numbers of one group and refuses other keys in it.
template <std::size_t kCount>
void readGroup(const ros::NodeHandle& nh, const std::array<NamedValue, kCount>& values) {
  std::vector<std::string> known;
  for (const auto& [name, value] : values) {
    known.emplace_back(name);
    sylph_ros::read(nh, name, *value);
  }
  sylph_ros::requireKnown(nh, known);
}

BaseOptions loadBase(const ros::NodeHandle& nh) {
  BaseOptions base;
  readGroup(nh, std::array<NamedValue, 15>{{
                    {"wheel_radius_m", &base.geometry.wheel_radius_m},
                    {"half_wheelbase_m", &base.geometry.half_wheelbase_m},
                    {"half_track_m", &base.geometry.half_track_m},
                    {"wheel_speed_limit_radps", &base.wheel_speed_limit_radps},
                    {"wheel_acceleration_limit_radps2", &base.wheel_acceleration_limit_radps2},
                    {"wheel_lag_s", &base.wheel_lag_s},
                    {"command_latency_s", &base.command_latency_s},
                    {"command_timeout_s", &base.command_timeout_s},
                    {"command_resolution", &base.command_resolution},
                    {"wheel_scale_error", &base.wheel_scale_error},
                    {"speed_noise", &base.speed_noise},
                    {"slip", &base.slip},
                    {"slip_noise", &base.slip_noise},
                    {"lateral_slip", &base.lateral_slip},
                    {"noise_correlation_s", &base.noise_correlation_s},
                }});
  for (const auto& [name, value] : {NamedValue{"wheel_radius_m", &base.geometry.wheel_radius_m},
                                    NamedValue{"half_wheelbase_m", &base.geometry.half_wheelbase_m},
                                    NamedValue{"half_track_m", &base.geometry.half_track_m}}) {
    sylph_ros::requirePositive(nh, name, *value);
  }
  return base;
}

CameraOptions loadCameras(const ros::NodeHandle& nh) {
  CameraOptions cameras;
  readGroup(nh, std::array<NamedValue, 8>{{
                    {"rate_hz", &cameras.rate_hz},
                    {"latency_s", &cameras.latency_s},
                    {"position_noise_m", &cameras.position_noise_m},
                    {"yaw_noise_rad", &cameras.yaw_noise_rad},
                    {"body_offset_m", &cameras.body_offset_m},
                    {"body_yaw_offset_rad", &cameras.body_yaw_offset_rad},
                    {"occlusion_probability", &cameras.occlusion_probability},
                    {"frame_loss_probability", &cameras.frame_loss_probability},
                }});
  return cameras;
}

void readAddress(const ros::NodeHandle& nh, const std::string& name,
                 sylph_natnet::Ipv4Address& address) {
  std::string text = sylph_natnet::toString(address);
  sylph_ros::read(nh, name, text);
  address = sylph_natnet::addressFromString(text);
}

NatNetOptions loadNatNet(const ros::NodeHandle& nh) {
  NatNetOptions natnet;
  std::string version = sylph_natnet::toString(natnet.version);
  sylph_ros::read(nh, "version", version);
  natnet.version = sylph_natnet::versionFromString(version);
  readAddress(nh, "address", natnet.address);
  readAddress(nh, "multicast_group", natnet.multicast_group);
  sylph_ros::read(nh, "multicast", natnet.multicast);
  sylph_ros::read(nh, "command_port", natnet.command_port);
  sylph_ros::requireInRange(nh, "command_port", natnet.command_port, 0, 65535);
  sylph_ros::read(nh, "data_port", natnet.data_port);
  sylph_ros::requireInRange(nh, "data_port", natnet.data_port, 0, 65535);
  std::string up_axis = toString(natnet.up_axis);
  sylph_ros::read(nh, "up_axis", up_axis);
  natnet.up_axis = upAxisFromString(up_axis);
  sylph_ros::read(nh, "body_height_m", natnet.body_height_m);
  sylph_ros::requireInRange(nh, "body_height_m", natnet.body_height_m, 0.0, 10.0);
  sylph_ros::requireKnown(nh, {"address", "body_height_m", "command_port", "data_port", "multicast",
                               "multicast_group", "up_axis", "version"});
  return natnet;
}

double numberOf(XmlRpcValue& value, const std::string& field) {
  if (value.getType() == XmlRpcValue::TypeInt) {
    return static_cast<int>(value);
  }
  if (value.getType() != XmlRpcValue::TypeDouble) {
    throw std::runtime_error(field + ": must be a number");
  }
  return static_cast<double>(value);
}

std::string textOf(XmlRpcValue& value, const std::string& field) {
  if (value.getType() != XmlRpcValue::TypeString) {
    throw std::runtime_error(field + ": must be a text");
  }
  return static_cast<std::string>(value);
}

std::vector<std::size_t> robotsOf(XmlRpcValue& value, const sylph::Experiment& experiment) {
  if (value.getType() != XmlRpcValue::TypeArray) {
    throw std::runtime_error("robots: must be a list of names");
  }
  std::vector<std::size_t> robots;
  robots.reserve(static_cast<std::size_t>(value.size()));
  for (int i = 0; i < value.size(); ++i) {  // NOLINT(modernize-loop-convert): XmlRpc has no range
    robots.push_back(robotIndex(experiment, textOf(value[i], "robots")));
  }
  return robots;
}

Fault faultOf(XmlRpcValue& entry, const sylph::Experiment& experiment) {
  if (entry.getType() != XmlRpcValue::TypeStruct || !entry.hasMember("kind")) {
    throw std::runtime_error("must be {kind: ..., robots: [...], at_s: ..., duration_s: ...}");
  }
  Fault fault;
  fault.kind = faultKindFromName(textOf(entry["kind"], "kind"));
  fault.value = defaultValue(fault.kind);
  for (auto& [field, value] : entry) {
    if (field == "robots") {
      fault.robots = robotsOf(value, experiment);
    } else if (field == "at_s") {
      fault.at_s = numberOf(value, field);
    } else if (field == "duration_s") {
      fault.duration_s = numberOf(value, field);
    } else if (field == "value") {
      fault.value = numberOf(value, field);
    } else if (field != "kind") {
      throw std::runtime_error(field +
                               ": unknown; allowed are kind, robots, at_s, duration_s, value");
    }
  }
  FaultScript(experiment.robots.size()).add(fault, 0.0);  // checks bounds
  return fault;
}

}  // namespace

Options loadOptions(const ros::NodeHandle& private_nh) {
  Options options;
  SimulationOptions& simulation = options.simulation;
  sylph_ros::read(private_nh, "step_rate_hz", simulation.step_rate_hz);
  sylph_ros::read(private_nh, "start_offset_m", simulation.start_offset_m);
  sylph_ros::read(private_nh, "start_yaw_offset_rad", simulation.start_yaw_offset_rad);
  simulation.base = loadBase(ros::NodeHandle(private_nh, "base"));
  simulation.cameras = loadCameras(ros::NodeHandle(private_nh, "cameras"));
  options.natnet = loadNatNet(ros::NodeHandle(private_nh, "natnet"));
  sylph_ros::read(private_nh, "clock_period_s", options.clock_period_s);
  sylph_ros::requirePositive(private_nh, "clock_period_s", options.clock_period_s);
  sylph_ros::read(private_nh, "clock_wall_rate_limit_hz", options.clock_wall_rate_limit_hz);
  sylph_ros::requirePositive(private_nh, "clock_wall_rate_limit_hz",
                             options.clock_wall_rate_limit_hz);
  sylph_ros::read(private_nh, "truth_rate_hz", options.truth_rate_hz);
  sylph_ros::requirePositive(private_nh, "truth_rate_hz", options.truth_rate_hz);
  sylph_ros::requireKnown(private_nh,
                          {"base", "cameras", "clock_period_s", "clock_wall_rate_limit_hz",
                           "diagnostic_period", "faults", "natnet", "start_offset_m",
                           "start_yaw_offset_rad", "step_rate_hz", "truth_rate_hz"});
  requireValid(simulation);
  return options;
}

std::vector<Fault> loadFaults(const ros::NodeHandle& private_nh,
                              const sylph::Experiment& experiment) {
  XmlRpcValue list;
  if (!private_nh.getParam("faults", list)) {
    return {};
  }
  const std::string name = "parameter " + private_nh.resolveName("faults");
  if (list.getType() != XmlRpcValue::TypeArray) {
    throw std::runtime_error(name + ": must be a list");
  }
  std::vector<Fault> faults;
  for (int i = 0; i < list.size(); ++i) {
    try {
      faults.push_back(faultOf(list[i], experiment));
    } catch (const std::exception& error) {
      throw std::runtime_error(name + "[" + std::to_string(i) + "]: " + error.what());
    }
  }
  return faults;
}

}  // namespace sylph_sim
