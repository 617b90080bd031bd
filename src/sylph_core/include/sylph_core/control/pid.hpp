#pragma once

#include <limits>
#include <optional>

namespace sylph {

/// Gains and limits of a Pid. Units: e of the error, u of the output.
struct PidGains {
  double proportional = 0.0;                                        ///< [u/e], >= 0
  double integral = 0.0;                                            ///< [u/(e s)], >= 0
  double derivative = 0.0;                                          ///< [u s/e], >= 0
  double integral_limit = std::numeric_limits<double>::infinity();  ///< of its share [u], >= 0
  double output_limit = std::numeric_limits<double>::infinity();    ///< of |output| [u], > 0
  double derivative_cutoff_hz = 8.0;                                ///< of the low-pass, > 0
};

/// A PID controller for one axis.
///
///     u = P + I + D, limited to +-output_limit
///     P = proportional e
///     I = integral * sum(e dt), limited to +-integral_limit
///     D = -derivative * lowpass(dy/dt)
///
/// D looks at the measurement y and not at the error, so that a new set point gives no kick. The
/// low-pass is of first order. Anti-windup by conditional integration: while the output is limited,
/// here or by whoever uses it, I only moves towards zero or against the limit.
/// Astrom, Murray, "Feedback Systems", 2nd ed., section 11.4.
class Pid {
 public:
  /// @throws std::invalid_argument if a gain is negative or not finite, or a limit not positive
  explicit Pid(const PidGains& gains);

  /// One step.
  /// @param error        set point minus measurement [e]
  /// @param measurement  [e]; only its change counts
  /// @param dt_s         since the last step; <= 0 repeats a frame: neither I nor D moves
  /// @param is_limited_outside  the actuator could not follow the last output
  double update(double error, double measurement, double dt_s, bool is_limited_outside = false);

  /// Forgets the integral and the last measurement: for a new goal, or after being switched off.
  void reset();

  /// The share of the integral in the output [u].
  double integralShare() const { return integral_; }

 private:
  PidGains gains_;
  double integral_ = 0.0;
  double rate_ = 0.0;  // low-passed dy/dt
  std::optional<double> last_measurement_;
};

}  // namespace sylph
