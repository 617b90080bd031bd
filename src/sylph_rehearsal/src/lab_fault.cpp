#include "sylph_rehearsal/lab_fault.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "sylph_core/files/range.hpp"
#include "sylph_core/files/yaml_map.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph_rehearsal {
namespace {

using sylph_sim::FaultKind;

struct KindRow {
  LabFaultKind kind;
  const char* name;
};

constexpr std::array<KindRow, 12> kKinds{{
    {LabFaultKind::Network, "network"},
    {LabFaultKind::PoseNetwork, "pose_network"},
    {LabFaultKind::CrashCentral, "crash_central"},
    {LabFaultKind::CrashRobot, "crash_robot"},
    {LabFaultKind::CrashPlanner, "crash_planner"},
    {LabFaultKind::LaunchAnew, "launch_anew"},
    {LabFaultKind::CrashBridge, "crash_bridge"},
    {LabFaultKind::ClockSkew, "clock_skew"},
    {LabFaultKind::Pause, "pause"},
    {LabFaultKind::Stop, "stop"},
    {LabFaultKind::EmergencyStop, "emergency_stop"},
    {LabFaultKind::DeclareLost, "declare_lost"},
}};

constexpr std::array<FaultKind, 12> kSimulated{
    {FaultKind::Stuck, FaultKind::Slow, FaultKind::Dead, FaultKind::Deaf, FaultKind::Drift,
     FaultKind::Lost, FaultKind::Nan, FaultKind::Frozen, FaultKind::YawFlip, FaultKind::Jump,
     FaultKind::Swap, FaultKind::Silent}};

bool isOfLink(LabFaultKind kind) {
  return kind == LabFaultKind::Network || kind == LabFaultKind::PoseNetwork;
}

std::vector<std::string> kindNames() {
  std::vector<std::string> names;
  names.reserve(std::size(kSimulated) + std::size(kKinds));
  for (const FaultKind kind : kSimulated) {
    names.push_back(sylph_sim::toName(kind));
  }
  for (const KindRow& row : kKinds) {
    names.emplace_back(row.name);
  }
  return names;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", value);
  double read = 0.0;
  for (int digits = 1; digits < 17; ++digits) {  // as short as reads back the same
    std::snprintf(text, sizeof(text), "%.*g", digits, value);
    if (std::sscanf(text, "%lf", &read) == 1 && read == value) {
      break;
    }
  }
  return text;
}

std::vector<std::size_t> readRobots(const sylph::YamlMap& yaml,
                                    const sylph::Experiment& experiment) {
  std::vector<std::size_t> robots;
  if (!yaml.has("robots")) {
    return robots;
  }
  for (const std::string& name : yaml.texts("robots")) {
    const auto found =
        std::find_if(experiment.robots.begin(), experiment.robots.end(),
                     [&](const sylph::RobotSpec& robot) { return robot.name == name; });
    if (found == experiment.robots.end()) {
      throw yaml.error("robots", "'" + name + "' is not in the experiment");
    }
    robots.push_back(static_cast<std::size_t>(found - experiment.robots.begin()));
  }
  return robots;
}

LinkOptions readLink(const sylph::YamlMap& yaml) {
  LinkOptions link;
  const sylph::Range seconds = sylph::Range{0.0, 60.0};
  const sylph::Range probability = sylph::Range{0.0, 1.0};
  link.delay_s = yaml.number("delay_s", link.delay_s, seconds);
  link.jitter_s = yaml.number("jitter_s", link.jitter_s, seconds);
  link.held_up_s = yaml.number("held_up_s", link.held_up_s, seconds);
  link.loss = yaml.number("loss", link.loss, probability);
  link.doubling = yaml.number("doubling", link.doubling, probability);
  link.reordering = yaml.number("reordering", link.reordering, probability);
  return link;
}

LabFault readFault(const sylph::YamlMap& yaml, const sylph::Experiment& experiment) {
  LabFault fault;
  const std::string name = yaml.word("kind", kindNames(), yaml.text("kind"));
  const auto* const row = std::find_if(kKinds.begin(), kKinds.end(),
                                       [&](const KindRow& kind) { return name == kind.name; });
  if (row != kKinds.end()) {
    fault.kind = row->kind;
  } else {
    fault.fault.kind = sylph_sim::faultKindFromName(name);
    fault.fault.value = sylph_sim::defaultValue(fault.fault.kind);
  }
  fault.fault.robots = readRobots(yaml, experiment);
  fault.fault.at_s = yaml.number("at_s", 0.0, sylph::Range{0.0, 1e6});
  if (yaml.has("duration_s")) {
    fault.fault.duration_s = yaml.number("duration_s", sylph::Range{0.001, 1e6});
  }
  fault.fault.value = yaml.number("value", fault.fault.value, sylph::Range{-10.0, 10.0});
  if (isOfLink(fault.kind)) {
    fault.link = readLink(yaml);
  }
  yaml.refuseUnread();
  if (fault.kind == LabFaultKind::Simulated) {
    try {
      sylph_sim::FaultScript(experiment.robots.size()).add(fault.fault, 0.0);
    } catch (const std::invalid_argument& error) {
      throw yaml.error("kind", error.what());
    }
  }
  return fault;
}

/// How often each kind is drawn, with the bounds of its duration and value.
struct RandomRow {
  LabFaultKind kind;
  FaultKind simulated;
  double shortest_s;
  double longest_s;  ///< infinite: may last for good
  double least;
  double most;
};

constexpr double kForGood = std::numeric_limits<double>::infinity();
constexpr LabFaultKind kSim = LabFaultKind::Simulated;
constexpr FaultKind kNone = FaultKind::Stuck;

constexpr std::array<RandomRow, 22> kRandom{{
    {kSim, FaultKind::Stuck, 0.2, 20.0, 0.0, 0.0},
    {kSim, FaultKind::Slow, 1.0, kForGood, 0.2, 1.4},
    {kSim, FaultKind::Dead, 1.0, kForGood, 0.0, 0.0},
    {kSim, FaultKind::Deaf, 0.05, 5.0, 0.0, 0.0},
    {kSim, FaultKind::Drift, 0.5, 3.0, -0.01, 0.01},
    {kSim, FaultKind::Lost, 0.02, 3.0, 0.0, 0.0},
    {kSim, FaultKind::Nan, 0.02, 1.0, 0.0, 0.0},
    {kSim, FaultKind::Frozen, 0.05, 2.0, 0.0, 0.0},
    {kSim, FaultKind::YawFlip, 0.05, kForGood, 3.14159265358979323846, 3.14159265358979323846},
    {kSim, FaultKind::Jump, 0.05, kForGood, -0.1, 0.1},
    {kSim, FaultKind::Swap, 0.05, kForGood, 0.0, 0.0},
    {kSim, FaultKind::Silent, 0.05, 3.0, 0.0, 0.0},
    {LabFaultKind::Network, kNone, 1.0, 20.0, 0.0, 0.0},
    {LabFaultKind::PoseNetwork, kNone, 0.1, 5.0, 0.0, 0.0},
    {LabFaultKind::CrashCentral, kNone, 0.2, 5.0, 0.0, 0.0},
    {LabFaultKind::CrashRobot, kNone, 0.2, 5.0, 0.0, 0.0},
    {LabFaultKind::CrashPlanner, kNone, 0.2, 5.0, 0.0, 0.0},
    {LabFaultKind::CrashBridge, kNone, 0.2, 3.0, 0.0, 0.0},
    {LabFaultKind::ClockSkew, kNone, 1.0, kForGood, -0.03, 0.03},
    {LabFaultKind::Pause, kNone, 0.2, 5.0, 0.0, 0.0},
    {LabFaultKind::Stop, kNone, 0.2, 5.0, 0.0, 0.0},
    {LabFaultKind::DeclareLost, kNone, 1.0, kForGood, 0.0, 0.0},
}};

/// What befalls all robots at once, each in this share of the runs besides the faults above.
constexpr double kShareOfAll = 0.1;
constexpr std::array<RandomRow, 4> kRandomOfAll{{
    {LabFaultKind::EmergencyStop, kNone, 0.2, 10.0, 0.0, 0.0},
    {kSim, FaultKind::Lost, 0.02, 3.0, 0.0, 0.0},
    {kSim, FaultKind::Nan, 0.02, 1.0, 0.0, 0.0},
    {kSim, FaultKind::Frozen, 0.05, 2.0, 0.0, 0.0},
}};

/// Of different lengths alike: short faults are as telling as long ones.
double drawDuration(const RandomRow& row, sylph::Rng& rng) {
  constexpr double kLongest_s = 10.0;
  constexpr double kShareForGood = 0.2;
  if (std::isinf(row.longest_s) && sylph::drawFraction(rng) < kShareForGood) {
    return row.longest_s;
  }
  const double longest_s = std::isinf(row.longest_s) ? kLongest_s : row.longest_s;
  const double drawn_s =
      row.shortest_s * std::pow(longest_s / row.shortest_s, sylph::drawFraction(rng));
  return std::round(drawn_s * 1e3) / 1e3;
}

LinkOptions drawLink(LabFaultKind kind, sylph::Rng& rng) {
  LinkOptions link;
  const double longest_s = kind == LabFaultKind::Network ? 0.5 : 0.05;
  const auto draw = [&](double most) {
    return std::round(1e3 * most * sylph::drawFraction(rng)) / 1e3;
  };
  link.delay_s = draw(longest_s);
  link.jitter_s = draw(longest_s);
  link.loss = sylph::drawFraction(rng) < 0.2 ? 1.0 : draw(0.3);
  link.doubling = draw(0.2);
  link.reordering = draw(0.2);
  return link;
}

LabFault drawFault(const sylph::Experiment& experiment, sylph::Rng& rng, const RandomRow& row) {
  constexpr double kLatest_s = 40.0;
  LabFault fault;
  fault.kind = row.kind;
  fault.fault.kind = row.simulated;
  fault.fault.at_s = std::round(1e3 * kLatest_s * sylph::drawFraction(rng)) / 1e3;
  fault.fault.duration_s = drawDuration(row, rng);
  fault.fault.value = std::round(1e4 * sylph::drawBetween(rng, row.least, row.most)) / 1e4;
  const std::size_t count = experiment.robots.size();
  const std::size_t robot = sylph::drawIndex(rng, count);
  fault.fault.robots = {robot};
  if (row.kind == kSim && row.simulated == FaultKind::Swap) {
    fault.fault.robots.push_back((robot + 1 + sylph::drawIndex(rng, count - 1)) % count);
  } else if (isOfLink(row.kind) && sylph::drawFraction(rng) < 0.5) {
    fault.fault.robots.clear();  // all
  }
  if (isOfLink(row.kind)) {
    fault.link = drawLink(row.kind, rng);
  }
  return fault;
}

}  // namespace

std::string toName(const LabFault& fault) {
  if (fault.kind == LabFaultKind::Simulated) {
    return sylph_sim::toName(fault.fault.kind);
  }
  return std::find_if(kKinds.begin(), kKinds.end(),
                      [&](const KindRow& row) { return row.kind == fault.kind; })
      ->name;
}

std::string toYaml(const LabFault& fault, const sylph::Experiment& experiment) {
  std::string text = "{kind: " + toName(fault);
  if (!fault.fault.robots.empty()) {
    text += ", robots: [";
    text += sylph::join(fault.fault.robots, ", ",
                        [&](std::size_t robot) { return experiment.robots.at(robot).name; });
    text += "]";
  }
  text += ", at_s: " + number(fault.fault.at_s);
  if (std::isfinite(fault.fault.duration_s)) {
    text += ", duration_s: " + number(fault.fault.duration_s);
  }
  if (fault.fault.value != 0.0) {
    text += ", value: " + number(fault.fault.value);
  }
  if (isOfLink(fault.kind)) {
    text += ", delay_s: " + number(fault.link.delay_s) +
            ", jitter_s: " + number(fault.link.jitter_s) + ", loss: " + number(fault.link.loss) +
            ", doubling: " + number(fault.link.doubling) +
            ", reordering: " + number(fault.link.reordering);
  }
  return text + "}";
}

std::vector<LabFault> loadFaults(const std::string& path, const sylph::Experiment& experiment) {
  const sylph::YamlMap yaml = sylph::YamlMap::load(path);
  std::vector<LabFault> faults;
  for (const sylph::YamlMap& entry : yaml.maps("faults")) {
    faults.push_back(readFault(entry, experiment));
  }
  yaml.refuseUnread();
  return faults;
}

std::vector<LabFault> randomFaults(const sylph::Experiment& experiment, sylph::Rng& rng) {
  constexpr std::size_t kMost = 4;
  std::vector<LabFault> faults(1 + sylph::drawIndex(rng, kMost));
  for (LabFault& fault : faults) {
    fault = drawFault(experiment, rng, kRandom[sylph::drawIndex(rng, kRandom.size())]);
  }
  for (const RandomRow& row : kRandomOfAll) {
    if (sylph::drawFraction(rng) < kShareOfAll) {
      faults.push_back(drawFault(experiment, rng, row));
      faults.back().fault.robots.clear();
    }
  }
  return faults;
}

}  // namespace sylph_rehearsal
