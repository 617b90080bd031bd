#include "sylph_core/control/safety_margin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

/// Half the extent, along one axis of the grid, of a rectangle that is turned by up to `turn_rad`.
double reachAlong(double along_m, double across_m, double turn_rad) {
  // The reach grows with the angle up to that of the diagonal, and then falls.
  const double worst_rad = std::min(turn_rad, std::atan2(across_m, along_m));
  return (along_m * std::cos(worst_rad) + across_m * std::sin(worst_rad)) / 2.0;
}

/// The margin without verdict and remedies.
SafetyMargin gapsOf(const SafetyFactors& f) {
  SafetyMargin margin;
  margin.reach_m = std::max(reachAlong(f.length_m, f.width_m, f.heading_tolerance_rad),
                            reachAlong(f.width_m, f.length_m, f.heading_tolerance_rad));
  margin.error_m = std::max(f.tracking_error_m, f.position_tolerance_m);
  // Whichever takes longer: the node notices that poses are gone, or the base that commands are.
  margin.overrun_m =
      f.speed_limit_mps * (std::max(f.pose_timeout_s, f.base_timeout_s) + f.command_latency_s);
  margin.blind_travel_m =
      margin.overrun_m + f.speed_limit_mps * f.speed_limit_mps / (2.0 * f.acceleration_limit_mps2);
  const double clearance_m = f.cell_size_m - 2.0 * margin.reach_m;
  margin.separation_m = clearance_m - 2.0 * margin.error_m;
  // One robot of the two at a time: that both lose their poses in the same moment and drive at each
  // other is not covered.
  margin.blind_separation_m = clearance_m - margin.error_m - margin.overrun_m;
  return margin;
}

/// A number that may be changed, and how far.
struct Factor {
  const char* name;
  double SafetyFactors::*member;
  double extreme;  ///< best value that makes sense
};

constexpr double kLargestCell = 10.0;
constexpr Factor kFactors[] = {
    {"cell_size_m", &SafetyFactors::cell_size_m, kLargestCell},
    {"footprint length", &SafetyFactors::length_m, 0.01},
    {"heading_tolerance_rad", &SafetyFactors::heading_tolerance_rad, 0.0},
    {"tracking_error_m", &SafetyFactors::tracking_error_m, 0.0},
    {"position_tolerance_m", &SafetyFactors::position_tolerance_m, 0.0},
    {"speed_limit_mps", &SafetyFactors::speed_limit_mps, 0.01},
    {"pose_timeout_s", &SafetyFactors::pose_timeout_s, 0.0},
    {"base_timeout_s", &SafetyFactors::base_timeout_s, 0.0},
    {"command_latency_s", &SafetyFactors::command_latency_s, 0.0},
};

/// The value nearest to the present one with which no gap closes, if there is one.
std::optional<double> sufficientValue(const SafetyFactors& factors, const Factor& factor) {
  const auto isSafe = [&](double value) {
    SafetyFactors changed = factors;
    changed.*factor.member = value;
    return gapsOf(changed).promisedSeparation() > 0.0;
  };
  double unsafe = factors.*factor.member;
  double safe = factor.extreme;
  if (!isSafe(safe)) {
    return std::nullopt;
  }
  // The gap grows all the way from the present value to the extreme one.
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (safe + unsafe) / 2.0;
    (isSafe(middle) ? safe : unsafe) = middle;
  }
  return safe;
}

std::vector<std::string> remediesFor(const SafetyFactors& factors) {
  std::vector<std::string> remedies;
  for (const Factor& factor : kFactors) {
    const std::optional<double> value = sufficientValue(factors, factor);
    if (!value) {
      continue;
    }
    // Rounded to the safe side.
    const bool is_minimum = factor.extreme > factors.*factor.member;
    const double rounded = (is_minimum ? std::ceil(*value * 1e4) : std::floor(*value * 1e4)) / 1e4;
    remedies.push_back(std::string(factor.name) + format(" = %.4g", factors.*factor.member) +
                       (is_minimum ? " to at least " : " to at most ") + format("%.4g", rounded));
  }
  return remedies;
}

}  // namespace

double SafetyMargin::promisedSeparation() const {
  return std::min(separation_m, blind_separation_m);
}

std::string SafetyMargin::summary() const {
  return format("robots stay %.1f mm apart", separation_m * 1e3) +
         format(", and %.1f mm if one loses its pose", blind_separation_m * 1e3) +
         format(" (reach %.1f mm", reach_m * 1e3) + format(", error %.1f mm", error_m * 1e3) +
         format(", overrun %.1f mm)", overrun_m * 1e3);
}

SafetyMargin computeSafetyMargin(const SafetyFactors& factors) {
  SafetyMargin margin = gapsOf(factors);
  if (margin.separation_m <= 0.0) {
    margin.verdict = SafetyVerdict::Refuse;
  } else if (margin.blind_separation_m <= 0.0) {
    margin.verdict = SafetyVerdict::SlowDown;
  } else {
    margin.verdict = SafetyVerdict::Run;
  }
  if (margin.verdict != SafetyVerdict::Run) {
    margin.remedies = remediesFor(factors);
  }
  return margin;
}

}  // namespace sylph
