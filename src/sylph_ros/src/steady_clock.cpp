#include "sylph_ros/steady_clock.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "sylph_ros/parameters.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_ros {

SteadyClock::SteadyClock(double speed) : speed_(speed) {
  if (!std::isfinite(speed) || speed <= 0.0) {
    throw std::invalid_argument("clock speed " + std::to_string(speed) + ": must be > 0");
  }
}

SteadyClock SteadyClock::fromParameter(const ros::NodeHandle& suite_nh) {
  double speed = 1.0;
  read(suite_nh, kSpeedParameter, speed, sylph::Range::positive());
  return SteadyClock(speed);
}

}  // namespace sylph_ros
