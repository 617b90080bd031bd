// How the lab goes wrong, and right again.
#include <algorithm>
#include <cmath>

#include "lab.hpp"

namespace sylph_rehearsal {
namespace {

/// The operator tries again so often while no central node answers.
constexpr double kRetryPeriod_s = 1.0;

/// The button's node tells of it again so often while it is pressed.
constexpr double kButtonPeriod_s = 0.05;

}  // namespace

void Lab::begin(const LabFault& fault) {
  const std::vector<std::size_t>& robots = fault.fault.robots;
  switch (fault.kind) {
    case LabFaultKind::Simulated:
      simulate(fault.fault);
      return;  // it ends by itself
    case LabFaultKind::Network:
    case LabFaultKind::PoseNetwork:
      setLinks(fault, true);
      break;
    case LabFaultKind::CrashCentral:
      central_.crash();
      break;
    case LabFaultKind::CrashRobot:
      for (const std::size_t robot : robots) {
        robots_[robot]->crash();
        oracle_.onNodeDown(robot);
      }
      break;
    case LabFaultKind::CrashPlanner:
      planner_.crash();
      break;
    case LabFaultKind::LaunchAnew:
      central_.launchAnew();
      planner_.crash();
      return;
    case LabFaultKind::CrashBridge:
      bridge_.crash();
      break;
    case LabFaultKind::ClockSkew:
      for (const std::size_t robot : robots) {
        robots_[robot]->setClockOffset(fault.fault.value);
      }
      break;
    case LabFaultKind::Pause:
      central_.setMode(sylph::ExecutionMode::Pause, "by the operator");
      break;
    case LabFaultKind::Stop:
      central_.setMode(sylph::ExecutionMode::Stop, "by the operator");
      break;
    case LabFaultKind::EmergencyStop:
      is_button_pressed_ = true;
      braking_.onPressed(queue_.now());
      tellOfButton();
      break;
    case LabFaultKind::DeclareLost:
      for (const std::size_t robot : robots) {
        central_.declareLost(static_cast<int>(robot), "declared by the operator");
      }
      return;
  }
  if (std::isfinite(fault.fault.duration_s)) {
    queue_.after(fault.fault.duration_s, [this, &fault] { end(fault); });
  }
}

void Lab::end(const LabFault& fault) {
  switch (fault.kind) {
    case LabFaultKind::Network:
    case LabFaultKind::PoseNetwork:
      setLinks(fault, false);
      break;
    case LabFaultKind::CrashCentral:
      startCentral();
      break;
    case LabFaultKind::CrashRobot:
      for (const std::size_t robot : fault.fault.robots) {
        startRobot(robot);
      }
      break;
    case LabFaultKind::CrashPlanner:
      planner_.start();
      break;
    case LabFaultKind::CrashBridge:
      bridge_.start();
      break;
    case LabFaultKind::ClockSkew:
      for (const std::size_t robot : fault.fault.robots) {
        robots_[robot]->setClockOffset(0.0);
      }
      break;
    case LabFaultKind::Pause:
      resume(sylph::ExecutionMode::Pause);
      break;
    case LabFaultKind::EmergencyStop:
      is_button_pressed_ = false;
      onEmergencyStop(false, "");
      lookAtRobots();
      resume(sylph::ExecutionMode::Stop);
      break;
    case LabFaultKind::Stop:
      lookAtRobots();
      resume(sylph::ExecutionMode::Stop);
      break;
    case LabFaultKind::Simulated:
    case LabFaultKind::LaunchAnew:
    case LabFaultKind::DeclareLost:
      break;
  }
}

void Lab::simulate(sylph_sim::Fault fault) {
  fault.at_s = 0.0;
  simulation_.inject(fault);
  if (fault.kind != sylph_sim::FaultKind::Drift) {
    return;
  }
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    if (fault.robots.empty() || std::count(fault.robots.begin(), fault.robots.end(), robot) > 0) {
      oracle_.onPushed(robot);
    }
  }
}

void Lab::tellOfButton() {
  if (is_button_pressed_) {
    onEmergencyStop(true, "the emergency stop is pressed");
    queue_.after(kButtonPeriod_s, [this] { tellOfButton(); });
  }
}

void Lab::lookAtRobots() {
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    robots_[robot]->onLookedAt(simulation_.poses()[robot]);
  }
}

void Lab::setLinks(const LabFault& fault, bool has_fault) {
  const std::vector<std::size_t>& robots = fault.fault.robots;
  for (std::size_t robot = 0; robot < links_.size(); ++robot) {
    if (!robots.empty() && std::count(robots.begin(), robots.end(), robot) == 0) {
      continue;
    }
    RobotLinks& links = links_[robot];
    if (fault.kind == LabFaultKind::PoseNetwork) {
      links.poses.setOptions(has_fault ? fault.link : options_.cameras);
      continue;
    }
    for (Link* link : {&links.tasks, &links.state, &links.reports, &links.emergency}) {
      link->setOptions(has_fault ? fault.link : options_.network);
    }
  }
}

void Lab::startCentral() {
  if (central_.isUp()) {
    return;
  }
  central_.start();
  // Latched topics: who comes later gets the last message.
  planner_.sendAgain();
  monitor_.tell();
}

void Lab::startRobot(std::size_t robot) {
  if (!robots_[robot]->isUp()) {
    robots_[robot]->start();
    monitor_.tell();
  }
}

void Lab::resume(sylph::ExecutionMode mode) {
  const sylph::Execution* execution = central_.execution();
  if (execution != nullptr && execution->mode() != mode) {
    return;  // the mode has been changed since
  }
  if (!central_.setMode(sylph::ExecutionMode::Run, "by the operator")) {
    queue_.after(kRetryPeriod_s, [this, mode] { resume(mode); });
  }
}

}  // namespace sylph_rehearsal
