#include "sylph_core/mapf/metrics.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph {
namespace {

TEST(MetricsTest, AnAgentArrivesWhenItStaysForGood) {
  const Instance instance{Grid(1, 4), {{0, 0}, {0, 3}}, {{0, 1}, {0, 3}}, {}};
  // Agent 0 passes its goal, comes back and rests; agent 1 never moves.
  const Plan plan = {
      {{0, 0}, {0, 3}}, {{0, 1}, {0, 3}}, {{0, 2}, {0, 3}}, {{0, 1}, {0, 3}}, {{0, 1}, {0, 3}}};
  const PlanMetrics metrics = computeMetrics(instance, plan);
  EXPECT_EQ(4, metrics.steps);
  EXPECT_EQ(3, metrics.makespan);
  EXPECT_EQ(3, metrics.sum_of_costs);
  EXPECT_EQ(2, metrics.arrived);
}

TEST(MetricsTest, WhoNeverArrivesCostsTheWholePlan) {
  const Instance instance{Grid(1, 3), {{0, 0}}, {{0, 2}}, {}};
  const PlanMetrics metrics = computeMetrics(instance, {{{0, 0}}, {{0, 1}}});
  EXPECT_EQ(1, metrics.sum_of_costs);
  EXPECT_EQ(0, metrics.arrived);
}

TEST(MetricsTest, RefusesAPlanOfAnotherWidth) {
  const Instance instance{Grid(1, 3), {{0, 0}}, {{0, 2}}, {}};
  EXPECT_THROW(computeMetrics(instance, {}), std::invalid_argument);
  EXPECT_THROW(computeMetrics(instance, {{{0, 0}, {0, 1}}}), std::invalid_argument);
}

TEST(MetricsTest, LowerBoundSumsShortestPaths) {
  const Instance instance{
      Grid::fromText("...\n##.\n...\n"), {{0, 0}, {2, 2}}, {{2, 0}, {2, 1}}, {}};
  EXPECT_EQ(7, sumOfCostsLowerBound(instance));
}

}  // namespace
}  // namespace sylph
