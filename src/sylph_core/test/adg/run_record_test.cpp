#include "sylph_core/adg/run_record.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "sylph_core/adg/execution.hpp"

namespace sylph {
namespace {

TEST(RunRecordTest, SumsUpAMission) {
  RunRecord record;
  auto plan = std::make_shared<MissionPlan>();
  plan->planning_s = 0.5;
  record.add({10.0, {0, event::Mode{ExecutionMode::Stop, ""}}});
  record.add({10.0, {1, event::Started{plan}}});
  EXPECT_EQ(0.0, record.elapsed(11.0, false));
  record.add({12.0, {1, event::Released{0, 0}}});
  record.add({13.0, {1, event::Released{0, 1}}});
  EXPECT_EQ(3.0, record.elapsed(15.0, false));
  record.add({16.0, {1, event::Done{0, 0}}});
  EXPECT_EQ(4.0, record.elapsed(99.0, true));
  record.add({17.0, {1, event::Mode{ExecutionMode::Run, ""}}});
  record.add({18.0, {1, event::Mode{ExecutionMode::Stop, ""}}});
  record.add({18.5, {1, event::Mode{ExecutionMode::Stop, "again, for another reason"}}});
  record.addTrackingError(0.003);
  record.addTrackingError(0.002);
  record.addTrackingError(std::numeric_limits<double>::quiet_NaN());
  auto replacement = std::make_shared<MissionPlan>();
  replacement->planning_s = 0.25;
  replacement->replaces_plan_id = 1;
  record.add({19.0, {2, event::Started{replacement}}});

  const Execution nothing({"robot_0"}, 2, 2, 0.3, {});
  const RunResult result = record.result(nothing, 1.2);
  EXPECT_FALSE(result.success);
  EXPECT_EQ(1, result.stops) << "the stop before the mission does not count";
  EXPECT_EQ(1, result.replans);
  EXPECT_EQ(0.75, result.planning_s);
  EXPECT_EQ(4.0, result.execution_s);
  EXPECT_EQ(0.003, result.max_tracking_error_m);
  EXPECT_FALSE(result.min_separation_m.has_value());
}

}  // namespace
}  // namespace sylph
