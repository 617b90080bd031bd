#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "open_lab.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_rehearsal/rehearsal.hpp"

namespace sylph_rehearsal {
namespace {

/// Eight robots that drive side by side, and one press of the button.
Rehearsal pressed(std::uint32_t seed, double at_s, double duration_s) {
  std::vector<std::pair<sylph::Cell, sylph::Cell>> missions;
  missions.reserve(8);
  for (int column = 0; column < 8; ++column) {
    missions.push_back({{9, column}, {0, column}});
  }
  return rehearse(openLab(10, 8, missions, seed), {}, nullptr,
                  {faultOf(LabFaultKind::EmergencyStop, {}, at_s, duration_s)});
}

TEST(EmergencyStopTest, EveryRobotStandsWithinWhatTheMonitorReckonsWith) {
  const sylph::Experiment experiment = openLab(2, 2, {{{0, 0}, {0, 0}}});
  const double most_mps = 1.02 * experiment.execution.speed_limit_mps;
  std::size_t trips = 0;
  double longest_s = 0.0;
  for (std::uint32_t seed = 1; seed <= 25; ++seed) {
    const Rehearsal run = pressed(seed, 2.0 + 0.2 * seed, kForGood);
    EXPECT_EQ(Ending::Stopped, run.ending) << run.cause;
    EXPECT_EQ("stop: the emergency stop is pressed", run.cause);
    for (const EmergencyBraking& braking : run.brakings) {
      EXPECT_LE(braking.distance_m,
                sylph::stoppingDistance(sylph::separationLimits(experiment), most_mps));
      longest_s = std::max(longest_s, braking.duration_s);
      ++trips;
    }
  }
  EXPECT_GE(trips, 150U);
  EXPECT_LT(longest_s, 1.0);
}

TEST(EmergencyStopTest, ReleasedAndResumedTheMissionIsCarriedOut) {
  const Rehearsal run = pressed(1, 4.0, 2.0);
  EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
  EXPECT_FALSE(run.brakings.empty());
}

}  // namespace
}  // namespace sylph_rehearsal
