#include "sylph_core/control/pid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace sylph {
namespace {

void requireGain(const char* name, double value) {
  if (!std::isfinite(value) || value < 0.0) {
    throw std::invalid_argument(std::string("PID ") + name + " gain " + std::to_string(value) +
                                ": must be >= 0");
  }
}

void requireLimit(const char* name, bool is_valid, double value) {
  if (!is_valid) {
    throw std::invalid_argument(std::string("PID ") + name + " " + std::to_string(value) +
                                ": must be positive");
  }
}

}  // namespace

Pid::Pid(const PidGains& gains) : gains_(gains) {
  requireGain("proportional", gains.proportional);
  requireGain("integral", gains.integral);
  requireGain("derivative", gains.derivative);
  requireLimit("integral_limit", gains.integral_limit >= 0.0, gains.integral_limit);
  requireLimit("output_limit", gains.output_limit > 0.0, gains.output_limit);
  requireLimit("derivative_cutoff_hz", gains.derivative_cutoff_hz > 0.0,
               gains.derivative_cutoff_hz);
}

double Pid::update(double error, double measurement, double dt_s, bool is_limited_outside) {
  if (dt_s > 0.0) {
    if (last_measurement_) {
      // Of the measurement: the error also jumps when the goal does.
      const double rate = (measurement - *last_measurement_) / dt_s;
      const double time_constant_s = 1.0 / (2.0 * M_PI * gains_.derivative_cutoff_hz);
      rate_ += (rate - rate_) * dt_s / (dt_s + time_constant_s);
    }
    last_measurement_ = measurement;
  }
  const double direct = gains_.proportional * error - gains_.derivative * rate_;
  if (dt_s > 0.0) {
    const double grown = std::clamp(integral_ + gains_.integral * error * dt_s,
                                    -gains_.integral_limit, gains_.integral_limit);
    const bool is_limited =
        is_limited_outside || std::abs(direct + integral_) >= gains_.output_limit;
    // Anti-windup: at the limit the sum may shrink but not grow.
    const bool unwinds =
        std::abs(grown) < std::abs(integral_) || error * (direct + integral_) < 0.0;
    if (!is_limited || unwinds) {
      integral_ = grown;
    }
  }
  return std::clamp(direct + integral_, -gains_.output_limit, gains_.output_limit);
}

void Pid::reset() {
  integral_ = 0.0;
  rate_ = 0.0;
  last_measurement_.reset();
}

}  // namespace sylph
