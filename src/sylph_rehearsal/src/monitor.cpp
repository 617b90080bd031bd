#include "monitor.hpp"

namespace sylph_rehearsal {
namespace {

constexpr double kPeriod_s = 0.05;

}  // namespace

Monitor::Monitor(const std::vector<sylph::Footprint>& sizes, const sylph::SeparationLimits& limits,
                 std::vector<std::string> names, EventQueue& queue, StopPort stop)
    : watch_(sizes, limits),
      limit_m_(limits.limit_m),
      names_(std::move(names)),
      queue_(&queue),
      stop_(std::move(stop)) {}

void Monitor::start() {
  tell();
  queue_->after(kPeriod_s, [this] { tick(); });
}

void Monitor::tick() {
  if (has_tripped_) {
    tell();
  }
  queue_->after(kPeriod_s, [this] { tick(); });
}

void Monitor::onPose(int robot, const sylph::Pose2d& pose, double stamp_s) {
  if (!watch_.update(robot, pose, stamp_s) || has_tripped_) {
    return;
  }
  const sylph::PairGap& pair = *watch_.violation();
  has_tripped_ = true;
  reason_ = "separation monitor: " + names_.at(static_cast<std::size_t>(pair.robot_a)) + " and " +
            names_.at(static_cast<std::size_t>(pair.robot_b)) + " came too close";
  tell();
}

bool Monitor::reset() {
  if (watch_.closest().gap_m < limit_m_) {
    return false;
  }
  has_tripped_ = false;
  tell();
  return true;
}

}  // namespace sylph_rehearsal
