#include "sylph_core/benchmark/evaluation.hpp"

#include <gtest/gtest.h>

namespace sylph {
namespace {

TEST(EvaluationTest, APlanOfAnotherNumberOfAgentsCountsAsIfNobodyHadMoved) {
  const Instance instance = {Grid::fromText("...\n"), {{0, 0}}, {{0, 1}}, MotionModel()};
  PlanningResult result;
  result.outcome = Outcome::Solved;
  for (const Plan& plan : {Plan({{{0, 0}, {0, 2}}}), Plan({{{0, 0}}, {}})}) {
    result.plan = plan;
    const Evaluation evaluation = evaluate(instance, result);
    EXPECT_FALSE(evaluation.is_solved);
    EXPECT_EQ(ViolationKind::WrongAgentCount, evaluation.violation.value().kind);
    EXPECT_EQ(0, evaluation.metrics.steps);
    EXPECT_EQ(0, evaluation.metrics.arrived);
  }
}

}  // namespace
}  // namespace sylph
