#include "lab.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "sylph_core/adg/explanation.hpp"
#include "sylph_core/experiment/experiment_control.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"

namespace sylph_rehearsal {
namespace {

/// Not 0, which no clock of a lab shows.
constexpr double kStart_s = 1000.0;
/// After the last task is done robots come to rest.
constexpr double kRest_s = 1.0;
constexpr double kWaitPeriod_s = 0.1;
/// What is said of a robot with which nothing is wrong.
constexpr const char* kNoCause = "is on its way";

constexpr std::uint32_t kPhasePart = 1000;
constexpr std::uint32_t kLinkPart = 2000;
constexpr std::uint32_t kLinksOfRobot = 8;

sylph::RobotControllerOptions controllerOptions(const sylph::Experiment& experiment,
                                                const RehearsalOptions& options) {
  sylph::RobotControllerOptions controller;
  controller.base = options.base;
  applyExecution(experiment.execution, controller);
  controller.follower.lag_s = options.base.lag_s;
  controller.period_s = 1.0 / options.control_rate_hz;
  return controller;
}

sylph::ExecutionLimits limitsOf(const sylph::Experiment& experiment,
                                const RehearsalOptions& options) {
  sylph::ExecutionLimits limits = options.limits;
  applyExperiment(experiment, options.align, limits);
  return limits;
}

}  // namespace

Lab::Lab(sylph::Experiment experiment, const RehearsalOptions& options,
         const std::shared_ptr<const sylph::Policy>& policy, std::vector<LabFault> faults)
    : experiment_(std::move(experiment)),
      options_(options),
      queue_(kStart_s),
      simulation_(options.simulation, experiment_, kStart_s),
      setup_{controllerOptions(experiment_, options), options.report_rate_hz, experiment_.grid,
             cellFrameOf(experiment_)},
      to_planner_(queue_, options.computer, seeded(kLinkPart)),
      to_central_(queue_, options.computer, seeded(kLinkPart + 1)),
      to_monitor_(queue_, options.cameras, seeded(kLinkPart + 2)),
      central_(experiment_, limitsOf(experiment_, options), options.heartbeat_period_s, queue_,
               {[this](const sylph::TaskOrder& task) {
                  const auto robot = static_cast<std::size_t>(task.robot);
                  oracle_.onOrder(task, queue_.now() - kStart_s);
                  links_[robot].tasks.send([this, robot, task] { robots_[robot]->onTask(task); });
                },
                [this](const sylph::CentralState& state) { onCentralState(state); },
                [this](const sylph::AdgState& state) {
                  to_planner_.send([this, state] { planner_.onState(state); });
                },
                [this](const sylph::ExecutionEvent& event) { onEvent(event); }}),
      bridge_(experiment_.robots.size(), [this](std::size_t robot, const sylph::Pose2d& pose,
                                                double stamp_s) { onPose(robot, pose, stamp_s); }),
      monitor_(footprintsOf(experiment_), separationLimits(experiment_), namesOf(experiment_),
               queue_,
               [this](bool is_pressed, const std::string& reason) {
                 onEmergencyStop(is_pressed, reason);
               }),
      planner_(experiment_, policy, options.planning_s, queue_,
               {[this](const sylph::MissionPlan& plan) {
                  to_central_.send([this, plan] { central_.onPlan(plan); });
                },
                [this](sylph::ExecutionMode mode) {
                  to_central_.send([this, mode] { central_.setMode(mode, "by the planner"); });
                }}),
      oracle_(experiment_),
      braking_(experiment_.robots.size()),
      faults_(std::move(faults)),
      progress_s_(kStart_s),
      waits_s_(experiment_.robots.size() * experiment_.robots.size(), 0.0) {
  makeLinks();
  makeRobots();
}

sylph::Rng Lab::seeded(std::uint32_t part) const {
  std::seed_seq sequence{experiment_.seed, part};
  return sylph::Rng(sequence);
}

void Lab::makeLinks() {
  for (std::uint32_t robot = 0; robot < experiment_.robots.size(); ++robot) {
    const std::uint32_t first = kLinkPart + kLinksOfRobot * (robot + 1);
    const auto link = [&](const LinkOptions& options, std::uint32_t part) {
      return Link(queue_, options, seeded(first + part));
    };
    links_.push_back({link(options_.cameras, 0), link(options_.network, 1),
                      link(options_.network, 2), link(options_.network, 3),
                      link(options_.network, 4)});
  }
}

void Lab::makeRobots() {
  for (std::size_t robot = 0; robot < experiment_.robots.size(); ++robot) {
    robots_.push_back(std::make_unique<Robot>(
        setup_, queue_,
        Robot::Ports{
            [this, robot](const sylph::Twist2d& twist) { simulation_.command(robot, twist); },
            [this, robot](const sylph::RobotReport& report) { onReport(robot, report); }}));
  }
}

void Lab::start() {
  sylph::Rng rng = seeded(kPhasePart);
  bridge_.start();
  central_.start();
  monitor_.start();
  planner_.start();
  for (const auto& robot : robots_) {
    // Nodes of different computers are in no common phase.
    queue_.after(setup_.controller.period_s * sylph::drawFraction(rng),
                 [&node = *robot] { node.start(); });
  }
  for (const LabFault& fault : faults_) {
    queue_.after(fault.fault.at_s, [this, &fault] { begin(fault); });
  }
  queue_.after(simulation_.stepDuration(), [this] { step(); });
  queue_.after(kWaitPeriod_s, [this] { noteWaits(); });
}

void Lab::step() {
  for (const sylph_sim::CapturedFrame& frame : simulation_.step()) {
    bridge_.onFrame(frame, queue_.now());
  }
  oracle_.check(simulation_, queue_.now() - kStart_s);
  braking_.onStep(simulation_, queue_.now());
  is_over_ = !goesOn();
  queue_.at(simulation_.time() + simulation_.stepDuration(), [this] { step(); });
}

void Lab::onPose(std::size_t robot, const sylph::Pose2d& pose, double stamp_s) {
  links_[robot].poses.send([this, robot, pose, stamp_s] { robots_[robot]->onPose(pose, stamp_s); });
  to_monitor_.send(
      [this, robot, pose, stamp_s] { monitor_.onPose(static_cast<int>(robot), pose, stamp_s); });
  planner_.onPose(robot, pose);
}

void Lab::onEmergencyStop(bool is_pressed, const std::string& reason) {
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    links_[robot].emergency.send([this, robot, is_pressed] {
      if (is_pressed && robots_[robot]->isUp()) {
        oracle_.onStopHeard(robot, queue_.now() - kStart_s);
      }
      robots_[robot]->onEmergencyStop(is_pressed);
    });
  }
  to_central_.send([this, is_pressed, reason] { central_.onEmergencyStop(is_pressed, reason); });
}

void Lab::onCentralState(const sylph::CentralState& state) {
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    sylph::CentralState to_robot = state;
    to_robot.has_tasks_to_come = central_.hasTasksToCome(static_cast<int>(robot));
    to_robot.is_aligning = central_.execution()->aligned() == static_cast<int>(robot);
    links_[robot].state.send([this, robot, state = to_robot] {
      const sylph::Execution* execution = central_.execution();
      // What was sent before the operator resumed is late, and no order to stop any more.
      const bool has_to_stop = state.mode == sylph::ExecutionMode::Stop && execution != nullptr &&
                               execution->mode() == sylph::ExecutionMode::Stop;
      if (has_to_stop && robots_[robot]->isUp()) {
        oracle_.onStopHeard(robot, queue_.now() - kStart_s);
      }
      robots_[robot]->onCentralState(state);
    });
  }
}

void Lab::onReport(std::size_t robot, const sylph::RobotReport& report) {
  oracle_.onReport(robot, report, sylph::position(simulation_.poses()[robot]),
                   queue_.now() - kStart_s);
  links_[robot].reports.send(
      [this, robot, report] { central_.onReport(static_cast<int>(robot), report); });
}

void Lab::onEvent(const sylph::ExecutionEvent& event) {
  if (const auto* started = std::get_if<sylph::event::Started>(&event.what)) {
    oracle_.onStarted(*started->plan);
  }
  const auto* mode = std::get_if<sylph::event::Mode>(&event.what);
  if (mode != nullptr && mode->mode != sylph::ExecutionMode::Stop) {
    oracle_.onResumed();
  }
  // Events that tell of no progress, as conditions that come and go, would keep a stuck lab going.
  const bool is_progress = std::holds_alternative<sylph::event::Started>(event.what) ||
                           std::holds_alternative<sylph::event::Done>(event.what) ||
                           std::holds_alternative<sylph::event::Mode>(event.what);
  if (is_progress) {
    progress_s_ = queue_.now();
  }
}

void Lab::noteWaits() {
  if (const sylph::Execution* execution = central_.execution();
      execution != nullptr && execution->isUnderWay()) {
    for (int robot = 0; robot < execution->robotCount(); ++robot) {
      if (const auto wait = execution->graph()->waitOf(robot)) {
        const int blocker = execution->graph()->task(wait->blocker).agent;
        waits_s_[static_cast<std::size_t>(robot) * robots_.size() +
                 static_cast<std::size_t>(blocker)] += kWaitPeriod_s;
      }
    }
  }
  queue_.after(kWaitPeriod_s, [this] { noteWaits(); });
}

bool Lab::goesOn() {
  // After a violation nothing more is learnt, and robots that drive through each other would bring
  // many more.
  const double quiet_s = queue_.now() - progress_s_;
  if (!oracle_.violations().empty() || !planner_.failure().empty() ||
      queue_.now() - kStart_s > options_.time_limit_s || quiet_s > options_.quiet_s) {
    return false;
  }
  const sylph::Execution* execution = central_.execution();
  return execution == nullptr || execution->phase() != sylph::ExecutionPhase::Finished ||
         quiet_s < kRest_s;
}

std::string Lab::causeOfStop() const {
  if (!planner_.failure().empty()) {
    return planner_.failure();
  }
  const sylph::Execution* execution = central_.execution();
  if (execution == nullptr) {
    return "the central node is down";
  }
  const sylph::AdgState state = explain(*execution, queue_.now());
  if (!state.message.empty()) {
    const bool is_running = state.mode == sylph::ExecutionMode::Run;
    return (is_running ? toString(state.phase) : toString(state.mode)) + ": " + state.message;
  }
  if (state.phase == sylph::ExecutionPhase::Idle) {
    return "the central node has no plan";
  }
  std::string cause;
  for (const sylph::RobotExecution& robot : state.robots) {
    if (robot.condition == sylph::RobotCondition::Lost) {
      cause += (cause.empty() ? "" : "; ") + robot.robot + ": lost";
    }
    if (!robot.root_cause.empty() && robot.root_cause.find(kNoCause) == std::string::npos) {
      const std::string line = robot.root_cause_robot + ": " + robot.root_cause;
      if (cause.find(line) == std::string::npos) {
        cause += (cause.empty() ? "" : "; ") + line;
      }
    }
  }
  return cause;
}

Rehearsal Lab::run() {
  start();
  queue_.run(kStart_s + options_.time_limit_s + 1.0, [this] { return !is_over_; });
  return summary();
}

Rehearsal Lab::summary() {
  Rehearsal rehearsal;
  rehearsal.seed = experiment_.seed;
  rehearsal.faults = faults_;
  rehearsal.lab_s = queue_.now() - kStart_s;
  rehearsal.violations = oracle_.violations();
  rehearsal.brakings = braking_.brakings();
  rehearsal.event_log = central_.log();
  sylph::RunRecord& record = central_.record();
  record.setMinSeparation(simulation_.minSeparation());
  record.setCollisions(simulation_.collisions());
  if (central_.execution() != nullptr) {
    rehearsal.result = record.result(
        *central_.execution(), experiment_.cell_size_m / experiment_.execution.speed_limit_mps);
  }
  for (std::size_t pair = 0; pair < waits_s_.size(); ++pair) {
    if (waits_s_[pair] > 0.0) {
      rehearsal.waits.push_back({static_cast<int>(pair / robots_.size()),
                                 static_cast<int>(pair % robots_.size()), waits_s_[pair]});
    }
  }
  if (!rehearsal.violations.empty()) {
    rehearsal.ending = Ending::Violated;
    rehearsal.cause = rehearsal.violations.front().what;
  } else if (rehearsal.result.success) {
    rehearsal.ending = Ending::Finished;
  } else {
    rehearsal.cause = causeOfStop();
    // A stop is safe only if an operator can find out what it waits for.
    if (rehearsal.cause.empty()) {
      rehearsal.ending = Ending::Violated;
      rehearsal.cause = "nothing says why it stopped";
      rehearsal.violations.push_back({rehearsal.lab_s, rehearsal.cause});
    }
  }
  return rehearsal;
}

}  // namespace sylph_rehearsal
