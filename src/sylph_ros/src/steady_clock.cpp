#include "sylph_ros/steady_clock.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "sylph_ros/parameters.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_ros {
namespace {

bool isInLockStep(const ros::NodeHandle& suite_nh) {
  bool is_in_lock_step = false;
  read(suite_nh, kLockStepParameter, is_in_lock_step);
  return is_in_lock_step;
}

}  // namespace

SteadyClock::SteadyClock(double speed) : speed_(speed) {
  if (!std::isfinite(speed) || speed <= 0.0) {
    throw std::invalid_argument("clock speed " + std::to_string(speed) + ": must be > 0");
  }
}

SteadyClock SteadyClock::fromParameter(const ros::NodeHandle& suite_nh, LockStep::Stage stage) {
  if (isInLockStep(suite_nh)) {
    SteadyClock clock;
    clock.lock_step_ = std::make_shared<LockStep>(suite_nh, stage);
    return clock;
  }
  double speed = 1.0;
  read(suite_nh, kSpeedParameter, speed, sylph::Range::positive());
  return SteadyClock(speed);
}

SteadyClock SteadyClock::ofSpectator(const ros::NodeHandle& suite_nh) {
  if (isInLockStep(suite_nh)) {
    SteadyClock clock;
    // It takes no part in the lock step, so that a display which hangs stops no lab.
    clock.follows_ros_time_ = true;
    return clock;
  }
  return fromParameter(suite_nh);
}

double SteadyClock::now() const {
  if (lock_step_) {
    return lock_step_->now();
  }
  return follows_ros_time_ ? ros::Time::now().toSec() : ros::SteadyTime::now().toSec() * speed_;
}

Timer SteadyClock::createTimer(const ros::NodeHandle& nh, double period_s,
                               LockStep::Callback callback) const {
  if (lock_step_) {
    return Timer(lock_step_->addTimer(period_s, std::move(callback)));
  }
  return Timer(nh.createSteadyTimer(
      wall(period_s),
      [callback = std::move(callback)](const ros::SteadyTimerEvent&) { callback(); }));
}

}  // namespace sylph_ros
