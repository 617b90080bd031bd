#include "sylph_sim/fault.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "sylph_core/text/join.hpp"
#include "sylph_sim/bounds.hpp"

namespace sylph_sim {
namespace {

struct KindRow {
  FaultKind kind;
  const char* name;
  double default_value;
};

constexpr double kPi = 3.14159265358979323846;

constexpr std::array<KindRow, 12> kKinds{{
    {FaultKind::Stuck, "stuck", 0.0},
    {FaultKind::Slow, "slow", 0.2},
    {FaultKind::Dead, "dead", 0.0},
    {FaultKind::Deaf, "deaf", 0.0},
    {FaultKind::Drift, "drift", 0.05},
    {FaultKind::Lost, "lost", 0.0},
    {FaultKind::Nan, "nan", 0.0},
    {FaultKind::Frozen, "frozen", 0.0},
    {FaultKind::YawFlip, "yaw_flip", kPi},
    {FaultKind::Jump, "jump", 0.1},
    {FaultKind::Swap, "swap", 0.0},
    {FaultKind::Silent, "silent", 0.0},
}};

const KindRow& rowOf(FaultKind kind) {
  return *std::find_if(kKinds.begin(), kKinds.end(),
                       [kind](const KindRow& row) { return row.kind == kind; });
}

void apply(const Fault& fault, std::size_t robot, RobotFault& state) {
  switch (fault.kind) {
    case FaultKind::Stuck:
      state.base.speed_factor = 0.0;
      break;
    case FaultKind::Slow:
      state.base.speed_factor *= fault.value;
      break;
    case FaultKind::Dead:
      state.base.is_dead = true;
      break;
    case FaultKind::Deaf:
      state.is_deaf = true;
      break;
    case FaultKind::Drift:
      state.base.drift_mps += fault.value;
      break;
    case FaultKind::Lost:
      state.capture.is_lost = true;
      break;
    case FaultKind::Nan:
      state.capture.is_nan = true;
      break;
    case FaultKind::Frozen:
      state.capture.is_frozen = true;
      break;
    case FaultKind::YawFlip:
      state.capture.yaw_offset_rad += fault.value;
      break;
    case FaultKind::Jump:
      state.capture.x_offset_m += fault.value;
      break;
    case FaultKind::Swap:
      state.capture.shown_robot = fault.robots[robot == fault.robots[0] ? 1 : 0];
      break;
    case FaultKind::Silent:
      break;
  }
}

}  // namespace

FaultKind faultKindFromName(const std::string& name) {
  for (const KindRow& row : kKinds) {
    if (name == row.name) {
      return row.kind;
    }
  }
  throw std::invalid_argument(
      "fault kind '" + name + "': must be one of " +
      sylph::join(kKinds, ", ", [](const KindRow& row) { return row.name; }));
}

std::string toName(FaultKind kind) {
  return rowOf(kind).name;
}

double defaultValue(FaultKind kind) {
  return rowOf(kind).default_value;
}

FaultScript::FaultScript(std::size_t robot_count) : robot_count_(robot_count) {
  if (robot_count == 0) {
    throw std::invalid_argument("a fault script needs at least one robot");
  }
}

void FaultScript::add(const Fault& fault, double origin_s) {
  requireWithin("at_s", fault.at_s, sylph::Range::atLeast(0.0));
  if (!(fault.duration_s > 0.0)) {
    requireWithin("duration_s", fault.duration_s, sylph::Range::positive());
  }
  requireWithin("value", fault.value, {fault.kind == FaultKind::Slow ? 0.0 : -10.0, 10.0});
  for (const std::size_t robot : fault.robots) {
    if (robot >= robot_count_) {
      throw std::invalid_argument("fault robot " + std::to_string(robot) + ": must be in 0 ... " +
                                  std::to_string(robot_count_ - 1));
    }
  }
  if (fault.kind == FaultKind::Swap &&
      (fault.robots.size() != 2 || fault.robots[0] == fault.robots[1])) {
    throw std::invalid_argument("fault swap: must name two different robots");
  }
  Scheduled scheduled{fault, origin_s + fault.at_s, origin_s + fault.at_s + fault.duration_s};
  if (fault.kind == FaultKind::Dead) {
    scheduled.end_s = std::numeric_limits<double>::infinity();
  }
  if (scheduled.fault.robots.empty()) {
    scheduled.fault.robots.resize(robot_count_);
    std::iota(scheduled.fault.robots.begin(), scheduled.fault.robots.end(), 0);
  }
  faults_.push_back(scheduled);
}

FaultState FaultScript::stateAt(double time_s) const {
  FaultState state;
  state.robots.resize(robot_count_);
  for (std::size_t robot = 0; robot < robot_count_; ++robot) {
    state.robots[robot].capture.shown_robot = robot;
  }
  for (const Scheduled& scheduled : faults_) {
    if (time_s < scheduled.start_s || time_s >= scheduled.end_s) {
      continue;
    }
    state.is_silent = state.is_silent || scheduled.fault.kind == FaultKind::Silent;
    for (const std::size_t robot : scheduled.fault.robots) {
      apply(scheduled.fault, robot, state.robots[robot]);
    }
  }
  return state;
}

std::size_t FaultScript::activeCount(double time_s) const {
  return static_cast<std::size_t>(
      std::count_if(faults_.begin(), faults_.end(), [time_s](const Scheduled& scheduled) {
        return time_s >= scheduled.start_s && time_s < scheduled.end_s;
      }));
}

}  // namespace sylph_sim
