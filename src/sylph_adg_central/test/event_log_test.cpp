#include "sylph_adg_central/event_log.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "sylph_adg_central/run_record.hpp"

namespace sylph_adg_central {
namespace {

using sylph::ExecutionEvent;
using Kind = sylph::ExecutionEvent::Kind;

class EventLogTest : public testing::Test {
 protected:
  EventLogTest() : path_(testing::TempDir() + "sylph_event_log_test.jsonl") {
    std::filesystem::remove(path_);
  }
  ~EventLogTest() override { std::filesystem::remove(path_); }

  void write(const std::string& text) const { std::ofstream(path_, std::ios::app) << text; }
  std::string refusal() const {
    try {
      const EventLog log(path_, names_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    ADD_FAILURE() << "the log was accepted";
    return {};
  }

  static ExecutionEvent planEvent() {
    auto plan = std::make_shared<sylph::MissionPlan>();
    plan->plan_id = 7;
    plan->replaces_plan_id = 6;
    plan->planner = "test";
    plan->planning_s = 1.25;
    plan->robots = {"robot_1", "robot_0"};
    plan->goals = {{0, 1}, {2, 3}};
    plan->plan = {{{0, 0}, {2, 3}}, {{0, 1}, {2, 3}}};
    plan->social = {{{1, 1}, {15.0F, std::numeric_limits<float>::quiet_NaN()}}};
    ExecutionEvent event;
    event.kind = Kind::Started;
    event.plan_id = 7;
    event.plan = plan;
    return event;
  }

  std::string path_;
  std::vector<std::string> names_ = {"robot_0", "robot_1"};
};

TEST_F(EventLogTest, ThereAndBackIsTheIdentity) {
  {
    EventLog log(path_, names_);
    EXPECT_TRUE(log.past().empty());
    log.append({1.5, planEvent()});
    log.append({2.5, {Kind::Released, 7, 1, 3, ""}});
    log.append({3.5, {Kind::Mode, 7, -1, 2, "by the operator"}});
  }
  EventLog log(path_, names_);
  ASSERT_EQ(3u, log.past().size());
  const sylph::MissionPlan expected = *planEvent().plan;
  const sylph::MissionPlan& plan = *log.past()[0].event.plan;
  EXPECT_EQ(1.5, log.past()[0].stamp_s);
  EXPECT_EQ(7u, plan.plan_id);
  EXPECT_EQ(6u, plan.replaces_plan_id);
  EXPECT_EQ("test", plan.planner);
  EXPECT_EQ(1.25, plan.planning_s);
  EXPECT_EQ(expected.robots, plan.robots);
  EXPECT_EQ(expected.goals, plan.goals);
  EXPECT_EQ(expected.plan, plan.plan);
  EXPECT_EQ(expected.social[0].partners, plan.social[0].partners);
  EXPECT_EQ(15.0F, plan.social[0].svo_deg[0]);
  EXPECT_TRUE(std::isnan(plan.social[0].svo_deg[1]));
  const ExecutionEvent& released = log.past()[1].event;
  EXPECT_EQ(Kind::Released, released.kind);
  EXPECT_EQ(1, released.robot);
  EXPECT_EQ(3, released.number);
  const ExecutionEvent& mode = log.past()[2].event;
  EXPECT_EQ(-1, mode.robot);
  EXPECT_EQ("by the operator", mode.text);
}

TEST_F(EventLogTest, CutsOffWhatACrashLeftOfTheLastLine) {
  {
    EventLog log(path_, names_);
    log.append({1.0, {Kind::Released, 1, 0, 0, ""}});
  }
  write("{\"stamp\": 2.0, \"eve");
  {
    EventLog log(path_, names_);
    EXPECT_EQ(1u, log.past().size());
    log.append({3.0, {Kind::Done, 1, 0, 0, ""}});
  }
  EXPECT_EQ(2u, EventLog(path_, names_).past().size());
}

TEST_F(EventLogTest, NamesFileAndLineOfWhatIsWrong) {
  write("{\"stamp\": 1.0, \"event\": \"done\", \"plan_id\": 1, \"robot\": \"robot_0\"}\n");
  write("{\"stamp\": 1.0, \"event\": \"danced\", \"plan_id\": 1}\n");
  EXPECT_EQ(path_ + ":2: unknown event 'danced'", refusal());
  std::filesystem::remove(path_);
  write("{\"stamp\": 1.0, \"event\": \"done\", \"plan_id\": 1, \"robot\": \"robot_9\"}\n");
  EXPECT_EQ(path_ + ":1: robot 'robot_9' is not in the experiment", refusal());
  std::filesystem::remove(path_);
  write("[1, 2\n");
  EXPECT_EQ(0u, refusal().find(path_ + ":1: "));
  EXPECT_THROW(EventLog("/nowhere/events.jsonl", names_), std::runtime_error);
}

TEST(RunRecordTest, SumsUpAMission) {
  RunRecord record;
  ExecutionEvent started;
  started.kind = Kind::Started;
  auto plan = std::make_shared<sylph::MissionPlan>();
  plan->planning_s = 0.5;
  started.plan = plan;
  record.add({10.0, {Kind::Mode, 0, -1, 2, ""}});
  record.add({10.0, started});
  EXPECT_EQ(0.0, record.elapsed(11.0, false));
  record.add({12.0, {Kind::Released, 1, 0, 0, ""}});
  record.add({13.0, {Kind::Released, 1, 0, 1, ""}});
  EXPECT_EQ(3.0, record.elapsed(15.0, false));
  record.add({16.0, {Kind::Done, 1, 0, 0, ""}});
  EXPECT_EQ(4.0, record.elapsed(99.0, true));
  record.add({17.0, {Kind::Mode, 1, -1, 0, ""}});
  record.add({18.0, {Kind::Mode, 1, -1, 2, ""}});
  record.add({18.5, {Kind::Mode, 1, -1, 2, "again, for another reason"}});
  record.addTrackingError(0.003);
  record.addTrackingError(0.002);
  record.addTrackingError(std::numeric_limits<double>::quiet_NaN());
  auto replacement = std::make_shared<sylph::MissionPlan>();
  replacement->planning_s = 0.25;
  replacement->replaces_plan_id = 1;
  started.plan = replacement;
  record.add({19.0, started});

  const sylph::Execution nothing({"robot_0"}, 2, 2, 0.3, {});
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
}  // namespace sylph_adg_central
