#include "sylph_core/control/slip_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sylph {

SlipEstimator::SlipEstimator(const SlipOptions& options) : options_(options) {
  if (!(options.largest >= 0.0 && options.largest <= 0.5 && options.memory_m > 0.0 &&
        options.slowest_mps > 0.0)) {
    throw std::invalid_argument(
        "slip: largest must be 0 ... 0.5, memory and slowest speed must be > 0");
  }
}

void SlipEstimator::learn(const Vector2& predicted, const Vector2& measured, double duration_s) {
  learnAxis(forward_, predicted.x, measured.x, duration_s);
  learnAxis(sideways_, predicted.y, measured.y, duration_s);
}

void SlipEstimator::learnAxis(double& gain, double predicted_m, double measured_m,
                              double duration_s) const {
  // Slower the noise of poses outweighs what slip there is.
  if (!(std::abs(predicted_m) > options_.slowest_mps * duration_s) || duration_s <= 0.0) {
    return;
  }
  const double sign = predicted_m > 0.0 ? 1.0 : -1.0;
  const double step = sign * (measured_m - gain * predicted_m) / options_.memory_m;
  // A base that goes farther than told is not slipping: something else is wrong with it.
  gain = std::clamp(gain + step, 1.0 - options_.largest, 1.0);
}

Twist2d SlipEstimator::compensate(const Twist2d& wanted_robot) const {
  return {wanted_robot.x_mps / forward_, wanted_robot.y_mps / sideways_, wanted_robot.turn_radps};
}

}  // namespace sylph
