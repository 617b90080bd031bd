#include "sylph_sim/contact_monitor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sylph_core/grid/rng.hpp"

namespace sylph_sim {
namespace {

sylph::Footprint robotAt(double x_m, double y_m, double yaw_rad = 0.0) {
  return {{x_m, y_m}, yaw_rad, 0.23, 0.20};
}

TEST(ContactMonitorTest, OneRobotHasNoNeighbour) {
  ContactMonitor monitor;
  monitor.update({robotAt(0.0, 0.0)});
  EXPECT_EQ(std::numeric_limits<double>::infinity(), monitor.minSeparation());
  EXPECT_EQ(0U, monitor.collisions());
}

TEST(ContactMonitorTest, KeepsTheSmallestGapOfTheRun) {
  ContactMonitor monitor;
  monitor.update({robotAt(0.0, 0.0), robotAt(0.6, 0.0), robotAt(0.0, 0.5)});
  EXPECT_NEAR(0.30, monitor.minSeparation(), 1e-12);
  monitor.update({robotAt(0.0, 0.0), robotAt(0.3, 0.0), robotAt(0.0, 0.5)});
  EXPECT_NEAR(0.07, monitor.minSeparation(), 1e-12);
  monitor.update({robotAt(0.0, 0.0), robotAt(2.0, 0.0), robotAt(0.0, 2.5)});
  EXPECT_NEAR(0.07, monitor.minSeparation(), 1e-12);
}

TEST(ContactMonitorTest, CountsAContactOnceUntilThePairParts) {
  ContactMonitor monitor;
  for (const double x_m : {0.3, 0.2, 0.1, 0.3, 0.2}) {
    monitor.update({robotAt(0.0, 0.0), robotAt(x_m, 0.0)});
  }
  EXPECT_EQ(2U, monitor.collisions());
  EXPECT_EQ(0.0, monitor.minSeparation());
  EXPECT_EQ(1U, monitor.contacts().count({0, 1}));
}

TEST(ContactMonitorTest, CountsPairsAndNotRobots) {
  ContactMonitor monitor;
  monitor.update({robotAt(0.4, 0.0), robotAt(0.2, 0.0), robotAt(0.0, 0.0), robotAt(5.0, 0.0)});
  EXPECT_EQ(2U, monitor.collisions());
}

TEST(ContactMonitorTest, RobotsThatStartInContactCollideOnce) {
  ContactMonitor monitor;
  monitor.update({robotAt(0.0, 0.0), robotAt(0.1, 0.0)});
  EXPECT_EQ(1U, monitor.collisions());
}

TEST(ContactMonitorTest, EqualsTheComparisonOfAllPairs) {
  sylph::Rng rng(3);
  const auto draw = [&rng](double low, double high) { return sylph::drawBetween(rng, low, high); };
  for (int run = 0; run < 50; ++run) {
    ContactMonitor monitor;
    double expected_m = std::numeric_limits<double>::infinity();
    for (int time = 0; time < 4; ++time) {
      std::vector<sylph::Footprint> robots;
      robots.reserve(8);
      for (int robot = 0; robot < 8; ++robot) {
        robots.push_back(robotAt(draw(0.0, 3.0), draw(0.0, 3.0), draw(-3.0, 3.0)));
      }
      std::set<std::pair<std::size_t, std::size_t>> contacts;
      for (std::size_t a = 0; a < robots.size(); ++a) {
        for (std::size_t b = a + 1; b < robots.size(); ++b) {
          const double gap_m = sylph::footprintGap(robots[a], robots[b]);
          expected_m = std::min(expected_m, gap_m);
          if (gap_m <= 0.0) {
            contacts.insert({a, b});
          }
        }
      }
      monitor.update(robots);
      ASSERT_EQ(expected_m, monitor.minSeparation()) << "run " << run;
      ASSERT_EQ(contacts, monitor.contacts()) << "run " << run;
    }
  }
}

}  // namespace
}  // namespace sylph_sim
