#include "sylph_adg_central/event_log.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace sylph_adg_central {
namespace {

using sylph::ExecutionEvent;
namespace event = sylph::event;

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
    return {7, event::Started{plan}};
  }

  std::string path_;
  std::vector<std::string> names_ = {"robot_0", "robot_1"};
};

TEST_F(EventLogTest, ThereAndBackIsTheIdentity) {
  const std::vector<ExecutionEvent> written = {
      planEvent(),
      {8, event::Refused{"a rotation"}},
      {7, event::Abandoned{}},
      {7, event::Released{1, 3}},
      {7, event::Accepted{1, 4}},
      {7, event::Done{0, 2}},
      {7, event::Condition{1, sylph::RobotCondition::Blind, "no pose"}},
      {7, event::Lost{0, "by the operator"}},
      {7, event::Mode{sylph::ExecutionMode::Stop, "by the operator"}},
      {7, event::Phase{sylph::ExecutionPhase::AtCut}}};
  {
    EventLog log(path_, names_);
    EXPECT_TRUE(log.past().empty());
    for (const ExecutionEvent& entry : written) {
      log.append({1.5, entry});
    }
  }
  const EventLog log(path_, names_);
  ASSERT_EQ(written.size(), log.past().size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    EXPECT_EQ(1.5, log.past()[i].stamp_s);
    EXPECT_EQ(written[i].plan_id, log.past()[i].event.plan_id);
    ASSERT_EQ(written[i].what.index(), log.past()[i].event.what.index()) << i;
  }
  const auto at = [&](std::size_t i) { return log.past()[i].event.what; };
  const sylph::MissionPlan expected = *std::get<event::Started>(planEvent().what).plan;
  const sylph::MissionPlan plan = *std::get<event::Started>(at(0)).plan;
  EXPECT_EQ(7U, plan.plan_id);
  EXPECT_EQ(6U, plan.replaces_plan_id);
  EXPECT_EQ("test", plan.planner);
  EXPECT_EQ(1.25, plan.planning_s);
  EXPECT_EQ(expected.robots, plan.robots);
  EXPECT_EQ(expected.goals, plan.goals);
  EXPECT_EQ(expected.plan, plan.plan);
  EXPECT_EQ(expected.social[0].partners, plan.social[0].partners);
  EXPECT_EQ(15.0F, plan.social[0].svo_deg[0]);
  EXPECT_TRUE(std::isnan(plan.social[0].svo_deg[1]));
  EXPECT_EQ("a rotation", std::get<event::Refused>(at(1)).reason);
  EXPECT_EQ(1, std::get<event::Released>(at(3)).robot);
  EXPECT_EQ(3, std::get<event::Released>(at(3)).sequence);
  EXPECT_EQ(1, std::get<event::Accepted>(at(4)).robot);
  EXPECT_EQ(4, std::get<event::Accepted>(at(4)).count);
  EXPECT_EQ(0, std::get<event::Done>(at(5)).robot);
  EXPECT_EQ(2, std::get<event::Done>(at(5)).sequence);
  EXPECT_EQ(1, std::get<event::Condition>(at(6)).robot);
  EXPECT_EQ(sylph::RobotCondition::Blind, std::get<event::Condition>(at(6)).condition);
  EXPECT_EQ("no pose", std::get<event::Condition>(at(6)).reason);
  EXPECT_EQ(0, std::get<event::Lost>(at(7)).robot);
  EXPECT_EQ("by the operator", std::get<event::Lost>(at(7)).reason);
  EXPECT_EQ(sylph::ExecutionMode::Stop, std::get<event::Mode>(at(8)).mode);
  EXPECT_EQ("by the operator", std::get<event::Mode>(at(8)).reason);
  EXPECT_EQ(sylph::ExecutionPhase::AtCut, std::get<event::Phase>(at(9)).phase);
}

TEST_F(EventLogTest, CutsOffWhatACrashLeftOfTheLastLine) {
  {
    EventLog log(path_, names_);
    log.append({1.0, {1, event::Released{0, 0}}});
  }
  write(R"({"stamp": 2.0, "eve)");
  {
    EventLog log(path_, names_);
    EXPECT_EQ(1U, log.past().size());
    log.append({3.0, {1, event::Done{0, 0}}});
  }
  EXPECT_EQ(2U, EventLog(path_, names_).past().size());
}

TEST_F(EventLogTest, NamesFileAndLineOfWhatIsWrong) {
  write(
      "{\"stamp\": 1.0, \"event\": \"done\", \"plan_id\": 1, \"robot\": \"robot_0\", \"sequence\": "
      "0}\n");
  write("{\"stamp\": 1.0, \"event\": \"danced\", \"plan_id\": 1}\n");
  EXPECT_EQ(path_ + ":2: unknown event 'danced'", refusal());
  std::filesystem::remove(path_);
  write("{\"stamp\": 1.0, \"event\": \"done\", \"plan_id\": 1, \"robot\": \"robot_9\"}\n");
  EXPECT_EQ(path_ + ":1: robot 'robot_9' is not in the experiment", refusal());
  std::filesystem::remove(path_);
  write(
      "{\"stamp\": 1.0, \"event\": \"mode\", \"plan_id\": 1, \"mode\": \"fly\", \"reason\": "
      "\"\"}\n");
  EXPECT_EQ(path_ + ":1: unknown mode 'fly'", refusal());
  std::filesystem::remove(path_);
  write(
      "{\"stamp\": 1.0, \"event\": \"done\", \"plan_id\": 1, \"robot\": \"robot_0\", \"number\": "
      "0}\n");
  EXPECT_EQ(path_ +
                ":1: written by an earlier version of the suite, whose events had a 'number': "
                "start with a new run folder",
            refusal());
  std::filesystem::remove(path_);
  write("[1, 2\n");
  EXPECT_EQ(0U, refusal().find(path_ + ":1: "));
  EXPECT_THROW(EventLog("/nowhere/events.jsonl", names_), std::runtime_error);
}

}  // namespace
}  // namespace sylph_adg_central
