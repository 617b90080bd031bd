#pragma once

#include <string>
#include <vector>

#include "sylph_core/execution/execution_event.hpp"
#include "sylph_rehearsal/rehearsal.hpp"
#include "sylph_sim/simulation.hpp"

namespace sylph_rehearsal {

/// Sees the truth of the simulated lab and says what must never happen.
class Oracle {
 public:
  explicit Oracle(std::size_t robots) : robots_(robots) {}

  /// After each step of the simulation.
  void check(const sylph_sim::Simulation& simulation, double time_s);

  const std::vector<Violation>& violations() const { return violations_; }

 private:
  std::size_t robots_;
  std::uint32_t collisions_ = 0;
  std::uint32_t obstacle_entries_ = 0;
  std::vector<Violation> violations_;
};

}  // namespace sylph_rehearsal
