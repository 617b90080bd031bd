#include "sylph_core/experiment/experiment_margin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sylph_core/geometry/footprint.hpp"

namespace sylph {
namespace {

/// The lab's default robots.
Experiment lab() {
  Experiment experiment;
  experiment.path = "lab.yaml";
  experiment.robots.resize(2);
  return experiment;
}

TEST(SafetyMarginTest, TheLabsDefaultsHaveAMargin) {
  const SafetyMargin margin = requireSafetyMargin(lab());
  EXPECT_EQ(SafetyVerdict::Run, margin.verdict);
  EXPECT_TRUE(margin.remedies.empty());
  EXPECT_NEAR(0.0358, margin.separation_m, 1e-4);
  EXPECT_NEAR(0.0375, margin.overrun_m, 1e-9);
  EXPECT_NEAR(0.0375 + 0.0521, margin.blind_travel_m, 1e-4);
  EXPECT_NEAR(0.0103, margin.promisedSeparation(), 1e-4);
}

TEST(SafetyMarginTest, HeadingErrorsUseTheBudgetUp) {
  // Budget per robot for position errors, c/2 - (L/2 cos + W/2 sin), in millimetres.
  const std::vector<std::pair<double, double>> budget_mm = {{0.0, 35.0},  {5.0, 26.7}, {10.0, 19.4},
                                                            {15.0, 13.0}, {20.0, 7.7}, {25.0, 3.5}};
  for (const auto& [heading_deg, expected_mm] : budget_mm) {
    SafetyFactors factors = safetyFactors(lab());
    factors.heading_tolerance_rad = heading_deg * std::acos(-1.0) / 180.0;
    const double reach_m = computeSafetyMargin(factors).reach_m;
    EXPECT_NEAR(expected_mm, (0.15 - reach_m) * 1e3, 0.1) << heading_deg;
  }
}

TEST(SafetyMarginTest, FreeHeadingsReachHalfTheDiagonal) {
  SafetyFactors factors = safetyFactors(lab());
  factors.heading_tolerance_rad = std::acos(-1.0);
  const SafetyMargin margin = computeSafetyMargin(factors);
  EXPECT_NEAR(std::hypot(0.23, 0.20) / 2.0, margin.reach_m, 1e-12);
  EXPECT_EQ(SafetyVerdict::Refuse, margin.verdict);
}

TEST(SafetyMarginTest, ReachIsWhatFootprintsShow) {
  for (double turn_rad = 0.0; turn_rad < 1.5; turn_rad += 0.05) {
    SafetyFactors factors = safetyFactors(lab());
    factors.heading_tolerance_rad = turn_rad;
    double reach_m = 0.0;
    for (double t = -turn_rad; t <= turn_rad; t += 0.001) {
      for (const Point& corner : corners({{0.0, 0.0}, t, 0.23, 0.20})) {
        reach_m = std::max({reach_m, corner.x, corner.y});
      }
    }
    EXPECT_NEAR(reach_m, computeSafetyMargin(factors).reach_m, 2e-4) << turn_rad;
  }
}

TEST(SafetyMarginTest, SaysSlowDownWhereOnlyALostPoseIsDangerous) {
  SafetyFactors factors = safetyFactors(lab());
  factors.speed_limit_mps = 0.5;
  const SafetyMargin margin = computeSafetyMargin(factors);
  EXPECT_EQ(SafetyVerdict::SlowDown, margin.verdict);
  EXPECT_TRUE(std::any_of(margin.remedies.begin(), margin.remedies.end(), [](const auto& remedy) {
    return remedy.find("speed_limit_mps = 0.5 to at most 0.318") == 0;
  })) << testing::PrintToString(margin.remedies);
}

TEST(SafetyMarginTest, ABaseThatLatchesItsCommandUsesTheBudgetUp) {
  SafetyFactors factors = safetyFactors(lab());
  factors.base_timeout_s = 0.5;
  const SafetyMargin margin = computeSafetyMargin(factors);
  EXPECT_NEAR(0.25 * 0.55, margin.overrun_m, 1e-9);
  EXPECT_EQ(SafetyVerdict::SlowDown, margin.verdict);
  EXPECT_TRUE(std::any_of(margin.remedies.begin(), margin.remedies.end(), [](const auto& remedy) {
    return remedy.find("base_timeout_s = 0.5 to at most 0.141") == 0;
  })) << testing::PrintToString(margin.remedies);
}

TEST(SafetyMarginTest, EachRemedyAloneIsEnough) {
  SafetyFactors factors = safetyFactors(lab());
  factors.cell_size_m = 0.27;
  const SafetyMargin margin = computeSafetyMargin(factors);
  EXPECT_EQ(SafetyVerdict::SlowDown, margin.verdict);
  ASSERT_FALSE(margin.remedies.empty());
  EXPECT_EQ("cell_size_m = 0.27 to at least 0.2897", margin.remedies.front());
  factors.cell_size_m = 0.2897;
  EXPECT_EQ(SafetyVerdict::Run, computeSafetyMargin(factors).verdict);
}

TEST(SafetyMarginTest, RefusesAnExperimentAndNamesTheNumbers) {
  Experiment experiment = lab();
  experiment.cell_size_m = 0.25;
  try {
    requireSafetyMargin(experiment);
    FAIL() << "an experiment without margin was accepted";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(0U, message.find("lab.yaml: no safety margin: robots stay -14.2 mm apart"))
        << message;
    EXPECT_NE(std::string::npos, message.find("change cell_size_m = 0.25 to at least 0.2897"))
        << message;
  }
}

}  // namespace
}  // namespace sylph
