#include <gtest/gtest.h>

#include <map>
#include <set>

#include "execution_fixture.hpp"
#include "random_plan.hpp"

namespace sylph {
namespace {

using test::ExecutionTest;
using test::kCols;
using test::kRows;
using test::missionPlan;
using test::queue;
using test::Robot;
using test::uniform;

TEST_F(ExecutionTest, CarriesAPlanOut) {
  place(queue().front());
  submit(queue(), 1);
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase());
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished));
  EXPECT_EQ(3, arrivedRobots(*execution_));
  EXPECT_EQ(6, count<event::Released>());
  EXPECT_EQ(6, count<event::Done>());
  for (const Robot& robot : robots_) {
    EXPECT_EQ((std::vector<int>{0, 1}), robot.carried_out);
  }
}

TEST_F(ExecutionTest, APlanInWhichNobodyMovesIsFinishedAtOnce) {
  place(queue().front());
  submit({queue().front()}, 1);
  EXPECT_EQ(ExecutionPhase::Finished, execution_->phase());
  EXPECT_EQ(3, arrivedRobots(*execution_));
}

TEST_F(ExecutionTest, ShowsWhoWaitsForWhomAndWhy) {
  place(queue().front());
  submit(queue(), 1);
  now_s_ += 0.5;
  execution_->tick(now_s_);
  const double since_s = now_s_;
  now_s_ += 0.5;
  const RobotExecution waiting = view(0);
  EXPECT_EQ("robot_1", waiting.waits_for_robot);
  EXPECT_EQ((Cell{0, 1}), waiting.waits_for_cell);
  EXPECT_NEAR(now_s_ - since_s, waiting.waited_s, 1e-9);
  EXPECT_EQ("robot_2", waiting.root_cause_robot);
  EXPECT_EQ("is on its way from (0,2) to (0,3)", waiting.root_cause);
  EXPECT_EQ((std::vector<Cell>{{0, 0}}), waiting.held_cells);
  EXPECT_EQ((std::vector<Cell>{{0, 0}, {0, 1}, {0, 2}}), waiting.remaining_path);
  EXPECT_EQ((Cell{0, 2}), waiting.goal);
  EXPECT_TRUE(waiting.partner.empty());
  EXPECT_EQ("robot_1", view(2).partner);
  EXPECT_EQ(10.0F, view(2).svo_deg);
}

TEST_F(ExecutionTest, SendsAgainUntilTheRobotConfirms) {
  place(queue().front());
  execution_->submit(missionPlan(queue(), names_, 1), now_s_);
  ASSERT_EQ(2U, execution_->takeOrders(now_s_).size()) << "both tasks of robot 2, which leads";
  EXPECT_TRUE(execution_->takeOrders(now_s_ + 0.2).empty());
  const auto again = execution_->takeOrders(now_s_ + 0.31);
  ASSERT_EQ(2U, again.size());
  EXPECT_EQ(0, again.front().sequence);
  EXPECT_EQ(2, again.front().robot_tasks);
  robots_[2].take(again.front());
  now_s_ += 0.4;
  report(2);
  const auto rest = execution_->takeOrders(now_s_ + 1.0);
  ASSERT_EQ(1U, rest.size());
  EXPECT_EQ(1, rest.front().sequence);
}

TEST_F(ExecutionTest, IgnoresLateReportsAndThoseOfOtherPlans) {
  place(queue().front());
  submit(queue(), 4);
  RobotReport late = robots_[2].report(now_s_);
  late.done = 2;
  late.accepted = 2;
  late.plan_id = 3;
  execution_->report(2, late, now_s_);
  EXPECT_EQ(0, execution_->graph()->doneCount(2)) << "plan 3 is not plan 4";
  step();
  const int done = execution_->graph()->doneCount(2);
  ASSERT_GT(done, 0);
  RobotReport old = robots_[2].report(now_s_ - 1.0);
  old.report_id = 1;
  old.done = 0;
  old.accepted = 0;
  execution_->report(2, old, now_s_);
  EXPECT_TRUE(execution_->takeOrders(now_s_).empty()) << "an old report makes nothing new";
  EXPECT_EQ(done, execution_->graph()->doneCount(2));
}

TEST_F(ExecutionTest, ARobotThatStartsAgainDoesNoTaskTwice) {
  place(queue().front());
  submit(queue(), 1);
  step();
  ASSERT_EQ(1, robots_[2].done);
  Robot again;
  again.position = robots_[2].position;
  again.carried_out = robots_[2].carried_out;
  robots_[2] = again;
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished));
  EXPECT_EQ(std::vector<int>{1}, robots_[2].carried_out) << "task 0 was done before";
}

TEST_F(ExecutionTest, PauseReleasesNothingAndResumeGoesOn) {
  limits_.lookahead = 1;
  restart();
  place(queue().front());
  submit(queue(), 1);
  execution_->setMode(ExecutionMode::Pause, "by the operator");
  for (int i = 0; i < 5; ++i) {
    step();
  }
  EXPECT_EQ(1, robots_[2].done) << "it finishes what it has";
  EXPECT_EQ(0, robots_[1].done);
  EXPECT_EQ("by the operator", execution_->message());
  EXPECT_EQ("pause: by the operator", view(2).root_cause);
  execution_->setMode(ExecutionMode::Run, "by the operator");
  EXPECT_TRUE(stepUntil(ExecutionPhase::Finished));
}

TEST_F(ExecutionTest, APauseDoesNotLetStoppedRobotsDriveOn) {
  EXPECT_TRUE(execution_->setMode(ExecutionMode::Stop, "by the operator"));
  EXPECT_TRUE(execution_->setMode(ExecutionMode::Pause, "by the planner"));
  EXPECT_EQ(ExecutionMode::Stop, execution_->mode());
  EXPECT_EQ("by the operator", execution_->modeReason());
}

TEST_F(ExecutionTest, OnlyAResumeEndsAnEmergencyStopThatIsReleased) {
  execution_->setEmergencyStop(true, "two robots came too close");
  EXPECT_EQ("two robots came too close", execution_->modeReason());
  EXPECT_FALSE(execution_->setMode(ExecutionMode::Run, "by the operator"));
  execution_->setEmergencyStop(false, "");
  EXPECT_EQ(ExecutionMode::Stop, execution_->mode());
  EXPECT_TRUE(execution_->setMode(ExecutionMode::Run, "by the operator"));
  EXPECT_EQ(ExecutionMode::Run, execution_->mode());
}

TEST_F(ExecutionTest, NoticesSilenceBlindnessAndStandstill) {
  place(queue().front());
  submit(queue(), 1);
  const auto conditionOf = [&](int robot) { return execution_->monitor(robot).condition(); };
  // Robot 2 reports on and does not move; robot 1 says nothing.
  for (int i = 0; i < 60; ++i) {
    now_s_ += 0.1;
    report(0);
    report(2);
    execution_->tick(now_s_);
    if (i == 20) {
      EXPECT_EQ(RobotCondition::Silent, conditionOf(1));
      EXPECT_EQ(RobotCondition::Ok, conditionOf(2));
    }
  }
  EXPECT_EQ(RobotCondition::Stuck, conditionOf(2));
  EXPECT_EQ(RobotCondition::Ok, conditionOf(0)) << "who waits for others is not stuck";
  EXPECT_EQ("robot_2", view(0).root_cause_robot);
  EXPECT_EQ(0U, view(0).root_cause.find("no progress for "));
  RobotReport blind = robots_[2].report(now_s_);
  blind.state = RobotState::Blind;
  blind.detail = "pose 0.3 s old";
  execution_->report(2, blind, now_s_);
  execution_->tick(now_s_);
  EXPECT_EQ(RobotCondition::Blind, conditionOf(2));
  EXPECT_EQ("no good pose: pose 0.3 s old", view(0).root_cause);
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished));
  EXPECT_EQ(RobotCondition::Ok, conditionOf(2));
}

TEST_F(ExecutionTest, ARobotThatHoldsSaysWhyAtOnce) {
  place(queue().front());
  submit(queue(), 1);
  deliver();
  RobotReport holding = robots_[2].report(now_s_);
  holding.state = RobotState::Holding;
  holding.detail = "its pose does not follow the commands";
  execution_->report(2, holding, now_s_);
  EXPECT_EQ(RobotCondition::Ok, view(2).condition) << "it is not late yet";
  EXPECT_EQ("its pose does not follow the commands", view(2).root_cause);
  EXPECT_EQ("robot_2", view(0).root_cause_robot);
  EXPECT_EQ("its pose does not follow the commands", view(0).root_cause);
}

TEST_F(ExecutionTest, AStopIsNoStandstill) {
  place(queue().front());
  submit(queue(), 1);
  execution_->setMode(ExecutionMode::Stop, "by the operator");
  for (int i = 0; i < 100; ++i) {
    now_s_ += 0.1;
    reportAll();
    execution_->tick(now_s_);
  }
  EXPECT_EQ(RobotCondition::Ok, execution_->monitor(2).condition());
}

TEST_F(ExecutionTest, ALostRobotIsPlannedAround) {
  place(queue().front());
  submit(queue(), 1);
  execution_->declareLost(2, "declared by the operator");
  ASSERT_TRUE(stepUntil(ExecutionPhase::AtCut, {2}));
  EXPECT_EQ((Cell{0, 0}), view(0).cell);
  EXPECT_EQ((Cell{0, 1}), view(1).cell);
  // It has two tasks ahead, so it may be in any of three cells.
  const std::vector<Cell> held = {{0, 2}, {0, 3}, {0, 4}};
  EXPECT_EQ(held, view(2).held_cells);

  submit({{{0, 0}, {0, 1}}, {{0, 0}, {0, 2}}}, 2, 1, {"robot_0", "robot_1"});
  EXPECT_EQ(ExecutionPhase::Refused, execution_->phase()) << "it enters a cell that is held";
  submit({{{0, 0}, {0, 1}}, {{0, 0}, {1, 1}}, {{0, 1}, {1, 2}}}, 3, 1, {"robot_0", "robot_1"});
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase()) << execution_->message();
  EXPECT_EQ(held, view(2).held_cells);
  report(2);
  EXPECT_EQ(held, view(2).held_cells) << "what it says of plan 1 is over";
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished, {2}));
  EXPECT_EQ(held, view(2).held_cells);
  EXPECT_EQ((Cell{0, 1}), view(0).cell);
  EXPECT_EQ((Cell{1, 2}), view(1).cell);
  EXPECT_EQ(3, static_cast<int>(execution_->missionGoals().size()));
  EXPECT_EQ(0, arrivedRobots(*execution_)) << "nobody is where the mission wanted it";
}

TEST_F(ExecutionTest, APlanWithARobotThatIsLostMeanwhileEndsNothing) {
  place(queue().front());
  submit(queue(), 1);
  execution_->declareLost(2, "declared by the operator");
  ASSERT_TRUE(stepUntil(ExecutionPhase::AtCut, {2}));
  const Plan with_both = {{{0, 0}, {0, 1}}, {{0, 0}, {1, 1}}};
  // While it is made.
  execution_->declareLost(1, "declared by the operator");
  submit(with_both, 2, 1, {"robot_0", "robot_1"});
  EXPECT_EQ(ExecutionPhase::AtCut, execution_->phase()) << execution_->message();
  // The rest is planned without it, and that plan has the same id if the planner was started again.
  submit({{{0, 0}}, {{1, 0}}}, 2, 1, {"robot_0"});
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished, {1, 2}));
  EXPECT_EQ((Cell{1, 0}), view(0).cell);
}

TEST_F(ExecutionTest, APendingPlanWithARobotThatIsLostMeanwhileIsDropped) {
  place(queue().front());
  submit(queue(), 1);
  execution_->declareLost(2, "declared by the operator");
  ASSERT_TRUE(stepUntil(ExecutionPhase::AtCut, {2}));
  now_s_ += 10.0;
  report(0);
  submit({{{0, 0}, {0, 1}}, {{0, 0}, {1, 1}}}, 2, 1, {"robot_0", "robot_1"});
  EXPECT_NE(std::string::npos, execution_->message().find("robot_1 does not report"))
      << execution_->message();
  execution_->declareLost(1, "declared by the operator");
  submit({{{0, 0}}, {{1, 0}}}, 3, 1, {"robot_0"});
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished, {1, 2}));
  EXPECT_EQ((Cell{1, 0}), view(0).cell);
}

TEST_F(ExecutionTest, AtACutARobotMayStillComeBackToItsCentre) {
  place(queue().front());
  submit(queue(), 1);
  execution_->declareLost(2, "declared by the operator");
  ASSERT_TRUE(stepUntil(ExecutionPhase::AtCut, {2}));
  robots_[1].position.x += 0.05;
  report(1);
  submit({{{0, 0}, {0, 1}}, {{0, 0}, {1, 1}}}, 2, 1, {"robot_0", "robot_1"});
  EXPECT_EQ(ExecutionPhase::AtCut, execution_->phase()) << execution_->message();
  EXPECT_NE(std::string::npos, execution_->message().find("robot_1 stands 50 mm in x"))
      << execution_->message();
  robots_[1].position.x -= 0.05;
  step({2});
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase()) << execution_->message();
}

TEST_F(ExecutionTest, OthersGoOnWhereALostRobotIsInNobodysWay) {
  place(queue().front());
  submit(queue(), 1);
  execution_->declareLost(0, "declared by the operator");
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished, {0}));
  EXPECT_EQ(2, arrivedRobots(*execution_));
}

TEST_F(ExecutionTest, LongTroubleMakesARobotLostIfAskedFor) {
  limits_.lost_after_s = 3.0;
  restart();
  place(queue().front());
  submit(queue(), 1);
  ASSERT_TRUE(stepUntil(ExecutionPhase::AtCut, {2}));
  EXPECT_TRUE(execution_->monitor(2).isLost());
  EXPECT_GT(now_s_, 103.9);
  EXPECT_LT(now_s_, 104.5);
}

TEST_F(ExecutionTest, ALogReplaysIntoTheSameState) {
  place(queue().front());
  submit(queue(), 1);
  step();
  execution_->setMode(ExecutionMode::Pause, "by the operator");
  collect();
  const auto before = execution_->graph()->configuration();
  const auto released = execution_->graph()->releasedTasks();
  restart();
  for (const ExecutionEvent& event : log_) {
    execution_->replay(event);
  }
  EXPECT_TRUE(execution_->takeEvents().empty());
  EXPECT_EQ(before, execution_->graph()->configuration());
  EXPECT_EQ(released, execution_->graph()->releasedTasks());
  EXPECT_EQ(ExecutionMode::Pause, execution_->mode());
  EXPECT_EQ(1U, execution_->planId());
  EXPECT_TRUE(execution_->takeOrders(now_s_).empty()) << "robots have not told yet what they have";
  execution_->setMode(ExecutionMode::Run, "by the operator");
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished));
  for (const Robot& robot : robots_) {
    EXPECT_EQ((std::vector<int>{0, 1}), robot.carried_out);
  }
}

TEST_F(ExecutionTest, ReplayRefusesWhatCannotHaveHappened) {
  EXPECT_THROW(execution_->replay({1, event::Done{0, 0}}), std::invalid_argument);
  EXPECT_THROW(execution_->replay({1, event::Started{nullptr}}), std::invalid_argument);
}

/// Random missions over a bad line, with restarts of both ends.
class ExecutionProperty : public ExecutionTest {
 protected:
  ExecutionProperty() : ExecutionTest(8) {}

  void begin(const Configuration& cells, const Plan& plan) {
    restart();
    log_.clear();
    robots_.assign(cells.size(), Robot());
    walked_.assign(cells.size(), {});
    in_flight_.clear();
    place(cells);
    execution_->submit(missionPlan(plan, names_, 1), now_s_);
  }

  /// Some orders get lost.
  void order(Rng& rng) {
    for (const TaskOrder& order : execution_->takeOrders(now_s_)) {
      if (uniform(0, 3, rng) > 0) {
        robots_[index(order.robot)].take(order);
      }
    }
  }

  /// Some carry a task out; their reports are sent once, more often or not at all.
  void act(Rng& rng) {
    std::set<std::pair<int, int>> places;
    for (int i = 0; i < 8; ++i) {
      Robot& robot = robots_[index(i)];
      if (uniform(0, 2, rng) > 0 && robot.hasTask()) {
        robot.carryOut(frame_);
        walked_[index(i)].push_back(frame_.toCell(robot.position));
      }
      const Cell cell = frame_.toCell(robot.position);
      ASSERT_TRUE(places.insert({cell.row, cell.col}).second) << "collision";
      const int copies = uniform(0, 2, rng);
      const RobotReport report = robot.report(now_s_);
      for (int copy = 0; copy < copies; ++copy) {
        in_flight_.emplace_back(i, report);
      }
      // A robot that has told what it has done may forget everything.
      if (robot.done == execution_->graph()->doneCount(i) && uniform(0, 30, rng) == 0) {
        const Point position = robot.position;
        robot = Robot();
        robot.position = position;
      }
    }
  }

  /// Reports arrive late and in any order.
  void deliver(Rng& rng) {
    shuffle(in_flight_, rng);
    while (in_flight_.size() > 6) {
      execution_->report(in_flight_.back().first, in_flight_.back().second, now_s_);
      in_flight_.pop_back();
    }
    execution_->tick(now_s_);
  }

  void restartSometimes(Rng& rng) {
    if (uniform(0, 40, rng) == 0) {
      collect();
      restart();
      for (const ExecutionEvent& event : log_) {
        execution_->replay(event);
      }
    }
  }

  std::vector<std::vector<Cell>> walked_;  // by robot

 private:
  std::vector<std::pair<int, RobotReport>> in_flight_;
};

/// Where an agent goes, without its waits.
std::vector<Cell> entered(const Plan& plan, std::size_t agent) {
  std::vector<Cell> cells;
  for (std::size_t t = 1; t < plan.size(); ++t) {
    if (plan[t][agent] != plan[t - 1][agent]) {
      cells.push_back(plan[t][agent]);
    }
  }
  return cells;
}

TEST_F(ExecutionProperty, ArrivesOverABadLineWithRestartsOfBothEnds) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    limits_.lookahead = uniform(1, 5, rng);
    Configuration cells = Grid(kRows, kCols).freeCells();
    shuffle(cells, rng);
    cells.resize(robots_.size());
    const Plan plan = test::randomWalk(Grid(kRows, kCols), cells, 12, false, rng);
    begin(cells, plan);
    for (int round = 0; execution_->phase() != ExecutionPhase::Finished; ++round) {
      ASSERT_LT(round, 3000) << "deadlock";
      now_s_ += 0.1;
      collect();
      order(rng);
      ASSERT_NO_FATAL_FAILURE(act(rng));
      deliver(rng);
      restartSometimes(rng);
    }
    for (std::size_t agent = 0; agent < robots_.size(); ++agent) {
      ASSERT_EQ(entered(plan, agent), walked_[agent]);
    }
  }
}

}  // namespace
}  // namespace sylph
