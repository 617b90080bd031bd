#include "sylph_core/adg/action_dependency_graph.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "sylph_core/adg/schedule.hpp"

namespace sylph {
namespace {

using Ids = std::vector<TaskId>;

/// The refusal of a plan, which has to come.
PlanRefused refusalOf(const Plan& plan, const std::vector<std::string>& names = {}) {
  try {
    const ActionDependencyGraph graph(plan, names);
  } catch (const PlanRefused& refused) {
    return refused;
  }
  ADD_FAILURE() << "the plan was accepted";
  return {0, {}, ""};
}

TEST(ActionDependencyGraphTest, DropsWaitsAndKeepsThePlanStep) {
  const ActionDependencyGraph graph({{{0, 0}}, {{0, 0}}, {{0, 1}}, {{0, 1}}, {{1, 1}}});
  ASSERT_EQ(2, graph.taskCount());
  EXPECT_EQ(1, graph.task(0).timestep);
  EXPECT_EQ(Action::East, graph.task(0).action);
  EXPECT_EQ(3, graph.task(1).timestep);
  EXPECT_EQ(1, graph.task(1).sequence);
  EXPECT_EQ(Ids{0}, graph.dependencies(1));
}

TEST(ActionDependencyGraphTest, AFollowerWaitsForWhoLeavesInTheSameStep) {
  // Agent 0 enters the cell that agent 1 leaves in the same timestep.
  const ActionDependencyGraph graph({{{0, 0}, {0, 1}}, {{0, 1}, {0, 2}}});
  const TaskId follow = graph.tasksOf(0).front();
  const TaskId lead = graph.tasksOf(1).front();
  EXPECT_EQ(Ids{lead}, graph.dependencies(follow));
  EXPECT_LT(lead, follow);
}

TEST(ActionDependencyGraphTest, OnlyTheLatestDepartureIsADependency) {
  // Agents 1 and 2 pass through (0,1) before agent 0 enters it.
  const ActionDependencyGraph graph({{{0, 0}, {0, 1}, {1, 1}},
                                     {{0, 0}, {0, 2}, {1, 1}},
                                     {{0, 0}, {1, 2}, {0, 1}},
                                     {{0, 0}, {1, 2}, {0, 2}},
                                     {{0, 1}, {1, 2}, {0, 2}}});
  EXPECT_EQ(Ids{graph.tasksOf(2)[1]}, graph.dependencies(graph.tasksOf(0).front()));
}

TEST(ActionDependencyGraphTest, OwnLeavingIsNoDependency) {
  const ActionDependencyGraph graph({{{0, 0}}, {{0, 1}}, {{0, 0}}});
  EXPECT_EQ(Ids{0}, graph.dependencies(1));
}

TEST(ActionDependencyGraphTest, RefusesARingAndNamesItsRobotsAndStep) {
  const Configuration from = {{2, 2}, {0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const Configuration to = {{2, 2}, {0, 1}, {1, 1}, {1, 0}, {0, 0}};
  const PlanRefused refused =
      refusalOf({from, from, to}, {"robot_0", "robot_1", "robot_2", "robot_3", "robot_4"});
  EXPECT_EQ(1, refused.timestep());
  EXPECT_EQ((std::vector<AgentId>{1, 2, 3, 4}), refused.agents());
  EXPECT_STREQ(
      "step 1: robot_1, robot_2, robot_3, robot_4 rotate, so that each would wait for "
      "the next one for ever",
      refused.what());
}

TEST(ActionDependencyGraphTest, RefusesARingOfEight) {
  Configuration from;
  Configuration to;
  const std::vector<Cell> rotation = {{0, 0}, {0, 1}, {0, 2}, {1, 2},
                                      {2, 2}, {2, 1}, {2, 0}, {1, 0}};
  for (std::size_t i = 0; i < rotation.size(); ++i) {
    from.push_back(rotation[i]);
    to.push_back(rotation[(i + 1) % rotation.size()]);
  }
  EXPECT_EQ(8U, refusalOf({from, to}).agents().size());
}

TEST(ActionDependencyGraphTest, RefusesASwap) {
  const PlanRefused refused = refusalOf({{{0, 0}, {0, 1}}, {{0, 1}, {0, 0}}});
  EXPECT_EQ((std::vector<AgentId>{0, 1}), refused.agents());
  EXPECT_NE(std::string::npos, std::string(refused.what()).find("swap"));
}

TEST(ActionDependencyGraphTest, RefusesToPassThroughWhoRestsForGood) {
  const PlanRefused refused =
      refusalOf({{{0, 0}, {1, 1}}, {{0, 0}, {0, 1}}, {{0, 0}, {0, 1}}, {{0, 1}, {0, 1}}},
                {"robot_0", "robot_1"});
  EXPECT_EQ(2, refused.timestep());
  EXPECT_EQ((std::vector<AgentId>{0, 1}), refused.agents());
  EXPECT_STREQ("step 2: robot_0 enters (0,1), which robot_1 holds and does not leave by then",
               refused.what());
}

TEST(ActionDependencyGraphTest, RefusesTwoThatEnterOneCell) {
  EXPECT_EQ((std::vector<AgentId>{1, 0}), refusalOf({{{0, 0}, {0, 2}}, {{0, 1}, {0, 1}}}).agents());
}

TEST(ActionDependencyGraphTest, RefusesWhatIsNoPlan) {
  EXPECT_STREQ("the plan has no configuration", refusalOf({}).what());
  EXPECT_EQ((std::vector<AgentId>{0, 1}), refusalOf({{{0, 0}, {0, 0}}}).agents());
  EXPECT_STREQ("step 0: agent 0 jumps from (0,0) to (1,1)", refusalOf({{{0, 0}}, {{1, 1}}}).what());
  EXPECT_STREQ("step 0: leads to a configuration of 1 agents instead of 2",
               refusalOf({{{0, 0}, {1, 1}}, {{0, 0}}}).what());
}

TEST(ActionDependencyGraphTest, NobodyMovesInAPlanOfOneConfiguration) {
  ActionDependencyGraph graph({{{0, 0}, {1, 1}}});
  EXPECT_TRUE(graph.release().empty());
  EXPECT_TRUE(graph.isFinished());
  EXPECT_EQ(0, computeSchedule(graph).critical_path);
}

/// Agent 0 runs along row 0; agent 1 crosses its way at (0,2) first.
Plan crossing() {
  return {{{0, 0}, {0, 2}}, {{0, 1}, {1, 2}}, {{0, 2}, {2, 2}}, {{0, 3}, {2, 2}}};
}

TEST(ActionDependencyGraphTest, ReleasesWhatDependenciesAllow) {
  ActionDependencyGraph graph(crossing());
  const Ids first = graph.tasksOf(0);
  const Ids second = graph.tasksOf(1);
  EXPECT_EQ((Ids{first[0], second[0]}), graph.release());
  EXPECT_TRUE(graph.release().empty());
  EXPECT_TRUE(graph.complete(first[0]));
  EXPECT_TRUE(graph.release().empty()) << "agent 1 has not left (0,2)";
  EXPECT_TRUE(graph.complete(second[0]));
  EXPECT_EQ((Ids{first[1], second[1]}), graph.release());
}

TEST(ActionDependencyGraphTest, LookaheadReleasesARunWithoutStops) {
  ActionDependencyGraph graph(crossing());
  EXPECT_EQ((Ids{graph.tasksOf(0)[0], graph.tasksOf(1)[0], graph.tasksOf(1)[1]}), graph.release(5));
  EXPECT_EQ((std::vector<Cell>{{0, 2}, {1, 2}, {2, 2}}), graph.heldCells(1));
  graph.complete(graph.tasksOf(1)[0]);
  EXPECT_EQ((Ids{graph.tasksOf(0)[1], graph.tasksOf(0)[2]}), graph.release(5));
  EXPECT_EQ((std::vector<Cell>{{1, 2}, {2, 2}}), graph.heldCells(1));
}

TEST(ActionDependencyGraphTest, CompletionIsIdempotentAndInOrder) {
  ActionDependencyGraph graph(crossing());
  EXPECT_THROW(graph.complete(graph.tasksOf(0)[0]), std::invalid_argument);
  graph.release(5);
  EXPECT_THROW(graph.complete(graph.tasksOf(1)[1]), std::invalid_argument);
  EXPECT_TRUE(graph.complete(graph.tasksOf(1)[0]));
  EXPECT_FALSE(graph.complete(graph.tasksOf(1)[0]));
  EXPECT_EQ(TaskStatus::Done, graph.status(graph.tasksOf(1)[0]));
  EXPECT_EQ((Cell{1, 2}), graph.cell(1));
}

TEST(ActionDependencyGraphTest, EnqueueKeepsToTheDependencies) {
  ActionDependencyGraph graph(crossing());
  EXPECT_THROW(graph.enqueue(graph.tasksOf(0)[1]), std::invalid_argument);
  graph.enqueue(graph.tasksOf(0)[0]);
  EXPECT_THROW(graph.enqueue(graph.tasksOf(0)[1]), std::invalid_argument);
  EXPECT_EQ(Ids{graph.tasksOf(0)[0]}, graph.releasedTasks());
}

TEST(ActionDependencyGraphTest, TellsWhoWaitsForWhomDownToTheRoot) {
  // A queue of three, led by agent 2.
  ActionDependencyGraph graph({{{0, 0}, {0, 1}, {0, 2}}, {{0, 1}, {0, 2}, {0, 3}}});
  graph.release(5);
  const auto wait = graph.waitOf(0);
  ASSERT_TRUE(wait.has_value());
  EXPECT_EQ(1, graph.task(wait->blocker).agent);
  EXPECT_EQ((Cell{0, 1}), graph.task(wait->task).end);
  EXPECT_EQ((std::vector<AgentId>{0, 1, 2}), graph.waitChain(0));
  EXPECT_EQ((std::vector<AgentId>{0, 1}), graph.blockedBy({2}));
  EXPECT_FALSE(graph.waitOf(2).has_value());
  EXPECT_TRUE(graph.blockedBy({0}).empty());
}

TEST(ScheduleTest, CriticalPathCrossesAgentsAndSlackIsWhatIsLeft) {
  // Agent 0 has three moves, the second of which follows agent 1's first.
  const Schedule schedule = computeSchedule(ActionDependencyGraph(crossing()));
  EXPECT_EQ(3, schedule.critical_path);
  EXPECT_EQ((std::vector<int>{0, 0}), schedule.slack);
  const Schedule queue = computeSchedule(ActionDependencyGraph({{{0, 0}, {0, 1}, {5, 5}, {7, 7}},
                                                                {{0, 1}, {0, 2}, {5, 5}, {7, 7}},
                                                                {{0, 1}, {0, 2}, {5, 6}, {7, 7}}}));
  EXPECT_EQ(2, queue.critical_path);
  EXPECT_EQ((std::vector<int>{0, 0, 1, 2}), queue.slack);
}

}  // namespace
}  // namespace sylph
