#include "sylph_sim/simulation.hpp"

#include <stdexcept>

#include "sylph_sim/bounds.hpp"

namespace sylph_sim {
namespace {

/// A generator of its own for each part of the simulation: none of them shifts another's numbers.
sylph::Rng seeded(std::uint32_t seed, std::uint32_t part) {
  std::seed_seq sequence{seed, part};
  return sylph::Rng(sequence);
}

constexpr std::uint32_t kPlacementPart = 1;
constexpr std::uint32_t kCameraPart = 2;
constexpr std::uint32_t kFirstRobotPart = 16;

bool isZero(const sylph::Twist2d& twist) {
  return twist.x_mps == 0.0 && twist.y_mps == 0.0 && twist.turn_radps == 0.0;
}

}  // namespace

void visitNumbers(SimulationOptions& options, const NumberVisitor& visit) {
  visit("step_rate_hz", options.step_rate_hz, sylph::Range::positive(), "steps a simulated second");
  visit("start_offset_m", options.start_offset_m, sylph::Range::atLeast(0.0),
        "robots start at most this far off their cell's centre");
  visit("start_yaw_offset_rad", options.start_yaw_offset_rad, sylph::Range::atLeast(0.0),
        "and turned by at most this");
}

void requireValid(const SimulationOptions& options) {
  requireNumbersWithin(options);
  requireValid(options.base);
  requireValid(options.cameras);
}

Simulation::Simulation(const SimulationOptions& options, const sylph::Experiment& experiment,
                       double start_s)
    : options_(options),
      experiment_(experiment),
      cell_frame_(sylph::cellFrameOf(experiment)),
      start_s_(start_s),
      step_s_(1.0 / options.step_rate_hz),
      time_s_(start_s),
      script_(experiment.robots.size()),
      faults_(script_.stateAt(start_s)),
      is_in_obstacle_(experiment.robots.size(), false) {
  requireValid(options);
  placeRobots();
  cameras_.emplace(options_.cameras, poses_, start_s, seeded(experiment_.seed, kCameraPart));
  updateTruth();
}

void Simulation::placeRobots() {
  sylph::Rng rng = seeded(experiment_.seed, kPlacementPart);
  const auto unit = [&rng] { return sylph::drawBetween(rng, -1.0, 1.0); };
  for (const sylph::RobotSpec& robot : experiment_.robots) {
    const sylph::Point center = cell_frame_.toPoint(robot.start);
    const double x_m = center.x + options_.start_offset_m * unit();
    const double y_m = center.y + options_.start_offset_m * unit();
    poses_.push_back({x_m, y_m, options_.start_yaw_offset_rad * unit()});
    const auto part = kFirstRobotPart + static_cast<std::uint32_t>(bases_.size());
    bases_.emplace_back(options_.base, poses_.back(), seeded(experiment_.seed, part));
  }
}

void Simulation::command(std::size_t robot, const sylph::Twist2d& twist_robot) {
  MecanumBase& base = bases_.at(robot);
  // Scheduled faults count from the first motion: how long nodes take to start differs from run to
  // run.
  if (!has_begun_ && !isZero(twist_robot)) {
    has_begun_ = true;
    for (const Fault& fault : not_begun_) {
      script_.add(fault, time_s_);
    }
    not_begun_.clear();
    faults_ = script_.stateAt(time_s_);
  }
  if (!faults_.robots[robot].is_deaf) {
    base.command(twist_robot, time_s_);
  }
}

void Simulation::schedule(const Fault& fault) {
  FaultScript(bases_.size()).add(fault, 0.0);  // a bad fault is refused now, not when it begins
  if (has_begun_) {
    inject(fault);
  } else {
    not_begun_.push_back(fault);
  }
}

void Simulation::inject(const Fault& fault) {
  script_.add(fault, time_s_);
  faults_ = script_.stateAt(time_s_);
}

std::vector<CapturedFrame> Simulation::step() {
  faults_ = script_.stateAt(time_s_);
  const std::vector<sylph::Pose2d> before = poses_;
  for (std::size_t robot = 0; robot < bases_.size(); ++robot) {
    bases_[robot].step(time_s_, step_s_, faults_.robots[robot].base);
    poses_[robot] = bases_[robot].pose();
  }
  // From the count of steps, so that rounding does not add up.
  time_s_ = start_s_ + static_cast<double>(++steps_) * step_s_;
  cameras_->capture(time_s_, before, poses_, faults_);
  updateTruth();
  return cameras_->takeDue(time_s_);
}

void Simulation::updateTruth() {
  std::vector<sylph::Footprint> footprints;
  footprints.reserve(poses_.size());
  for (std::size_t robot = 0; robot < poses_.size(); ++robot) {
    const sylph::RobotSpec& spec = experiment_.robots[robot];
    const sylph::Point center = sylph::position(poses_[robot]);
    footprints.push_back({center, poses_[robot].yaw_rad, spec.length_m, spec.width_m});
    const bool is_in_obstacle = !experiment_.grid.isFree(cell_frame_.toCell(center));
    obstacle_entries_ += is_in_obstacle && !is_in_obstacle_[robot] ? 1 : 0;
    is_in_obstacle_[robot] = is_in_obstacle;
  }
  contacts_.update(footprints);
}

}  // namespace sylph_sim
