#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sylph_rehearsal/rehearsal.hpp"
#include "sylph_sim/simulation.hpp"

namespace sylph_rehearsal {

/// Measures, by the truth, how far robots drive on after an emergency stop.
class BrakingMeter {
 public:
  explicit BrakingMeter(std::size_t robot_count) : robots_(robot_count) {}

  /// The button is pressed.
  void onPressed(double time_s);
  /// After each step of the simulation.
  void onStep(const sylph_sim::Simulation& simulation, double time_s);

  /// Of the robots that drove when it was pressed and have come to a standstill, in that order.
  const std::vector<EmergencyBraking>& brakings() const { return brakings_; }

 private:
  struct Robot {
    sylph::Point place;
    double speed_mps = 0.0;
    std::optional<EmergencyBraking> braking;  ///< under way
    double pressed_s = 0.0;
  };

  std::vector<Robot> robots_;
  std::vector<EmergencyBraking> brakings_;
};

}  // namespace sylph_rehearsal
