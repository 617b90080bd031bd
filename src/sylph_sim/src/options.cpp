#include "sylph_sim/options.hpp"

#include <XmlRpcValue.h>

#include <stdexcept>

namespace sylph_sim {
namespace {

using XmlRpc::XmlRpcValue;

using sylph_ros::ParameterReader;

/// Reads the numbers of some options.
template <typename Options>
void readNumbers(ParameterReader& reader, Options& options) {
  visitNumbers(options,
               [&reader](const std::string& name, double& value, const sylph::Range& range,
                         const std::string& meaning) { reader.read(name, value, range, meaning); });
}

void readNatNet(ParameterReader reader, NatNetOptions& natnet) {
  using sylph_natnet::addressFromString;
  using sylph_natnet::toString;
  const sylph::Range port{0.0, 65535.0};
  reader.readParsed("version", natnet.version, toString(natnet.version),
                    sylph_natnet::versionFromString, "bitstream, 2.0 ... 4.2");
  reader.readParsed("address", natnet.address, toString(natnet.address), addressFromString,
                    "of the interface to serve on");
  reader.read("command_port", natnet.command_port, port, "0: any free one");
  reader.read("data_port", natnet.data_port, port, "0: any free one");
  reader.read("multicast", natnet.multicast, "to the group; false: to each client by itself");
  reader.readParsed("multicast_group", natnet.multicast_group, toString(natnet.multicast_group),
                    addressFromString, "224.0.0.0 ... 239.255.255.255");
  reader.readChoice<UpAxis>("up_axis", natnet.up_axis, {{"y", UpAxis::Y}, {"z", UpAxis::Z}},
                            "must be what the bridge is told");
  reader.read("body_height_m", natnet.body_height_m, {0.0, 10.0},
              "of the rigid bodies above the floor");
}

void readLockStep(ParameterReader reader, LockStepOptions& lock_step) {
  const sylph::Range positive = sylph::Range::positive();
  reader.read("period_s", lock_step.period_s, positive,
              "lab time between two ticks; whole steps of the simulation");
  reader.read("clock_period_s", lock_step.clock_period_s, positive,
              "lab time between two `/clock` messages, by which only spectators go");
  reader.read("silent_after_s", lock_step.silent_after_s, positive,
              "wall time without an answer, after which the lab goes on without a node");
  reader.read("start_limit_s", lock_step.start_limit_s, positive,
              "wall time that the lab waits for nodes before it begins");
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

Options readOptions(ParameterReader& reader) {
  Options options;
  const sylph::Range positive = sylph::Range::positive();
  readNumbers(reader, options.simulation);
  ParameterReader base = reader.group("base");
  readNumbers(base, options.simulation.base);
  ParameterReader cameras = reader.group("cameras");
  readNumbers(cameras, options.simulation.cameras);
  readNatNet(reader.group("natnet"), options.natnet);
  readLockStep(reader.group("lock_step"), options.lock_step);
  reader.read("clock_period_s", options.clock_period_s, positive,
              "simulated time between two `/clock` messages");
  reader.read("clock_wall_rate_limit_hz", options.clock_wall_rate_limit_hz, positive,
              "`/clock` messages a wall second at most");
  reader.read("truth_rate_hz", options.truth_rate_hz, positive,
              "`simulation_truth` messages a simulated second");
  reader.readList("faults", "what goes wrong and when, see below");
  sylph_ros::readDiagnosticPeriod(reader);
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
