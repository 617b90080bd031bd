#include "braking_meter.hpp"

#include "sylph_core/geometry/segment.hpp"

namespace sylph_rehearsal {
namespace {

/// A slower robot stands.
constexpr double kStandstill_mps = 0.005;

}  // namespace

void BrakingMeter::onPressed(double time_s) {
  for (std::size_t index = 0; index < robots_.size(); ++index) {
    Robot& robot = robots_[index];
    if (!robot.braking && robot.speed_mps > kStandstill_mps) {
      robot.braking = EmergencyBraking{static_cast<int>(index), robot.speed_mps, 0.0, 0.0};
      robot.pressed_s = time_s;
    }
  }
}

void BrakingMeter::onStep(const sylph_sim::Simulation& simulation, double time_s) {
  for (std::size_t index = 0; index < robots_.size(); ++index) {
    Robot& robot = robots_[index];
    const sylph::Point place = sylph::position(simulation.poses()[index]);
    const double moved_m = distance(robot.place, place);
    robot.place = place;
    robot.speed_mps = moved_m / simulation.stepDuration();
    if (!robot.braking) {
      continue;
    }
    robot.braking->distance_m += moved_m;
    robot.braking->duration_s = time_s - robot.pressed_s;
    if (robot.speed_mps < kStandstill_mps) {
      brakings_.push_back(*robot.braking);
      robot.braking.reset();
    }
  }
}

}  // namespace sylph_rehearsal
