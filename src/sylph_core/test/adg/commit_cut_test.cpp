#include <gtest/gtest.h>

#include "sylph_core/adg/action_dependency_graph.hpp"

namespace sylph {
namespace {

/// Agents 0, 1, 2 in a queue that moves two cells east.
Plan queue() {
  return {{{0, 0}, {0, 1}, {0, 2}}, {{0, 1}, {0, 2}, {0, 3}}, {{0, 2}, {0, 3}, {0, 4}}};
}

std::string refusalOf(ActionDependencyGraph& graph, const std::vector<AgentId>& agents,
                      const Plan& plan) {
  try {
    graph.replaceRest(graph.commitCut(), agents, plan);
  } catch (const PlanRefused& refused) {
    return refused.what();
  }
  ADD_FAILURE() << "the plan was accepted";
  return {};
}

TEST(CommitCutTest, HoldsWhatIsReleasedAndWhatThatNeeds) {
  ActionDependencyGraph graph(queue());
  EXPECT_EQ((CommitCut{0, 0, 0}), graph.commitCut());
  // The second task of agent 0 needs the second of agent 1, and that the second of agent 2.
  EXPECT_EQ((CommitCut{2, 2, 2}), graph.commitCut(2));
  graph.release(2);
  EXPECT_EQ((CommitCut{0, 0, 2}), graph.commitCut());
  EXPECT_EQ((Configuration{{0, 0}, {0, 1}, {0, 4}}), graph.configurationAt(graph.commitCut()));
}

TEST(CommitCutTest, KnowsWhetherACutIsClosed) {
  const ActionDependencyGraph graph(queue());
  EXPECT_TRUE(graph.isClosed({0, 0, 0}));
  EXPECT_TRUE(graph.isClosed({0, 0, 1}));
  EXPECT_TRUE(graph.isClosed({1, 1, 1}));
  EXPECT_FALSE(graph.isClosed({1, 0, 1}));
  EXPECT_FALSE(graph.isClosed({0, 1, 0}));
  EXPECT_FALSE(graph.isClosed({0, 0})) << "one agent is missing";
  EXPECT_FALSE(graph.isClosed({0, 0, 3})) << "agent 2 has two tasks";
}

TEST(ReplaceRestTest, NewTasksWaitForUnfinishedOldOnes) {
  ActionDependencyGraph graph(queue());
  graph.release(1);  // agent 2 is on its way from (0,2) to (0,3)
  graph.replaceRest(graph.commitCut(), {0, 1, 2},
                    {{{0, 0}, {0, 1}, {0, 3}}, {{0, 0}, {0, 2}, {0, 3}}});
  ASSERT_EQ(2, graph.taskCount());
  EXPECT_EQ(graph.tasksOf(2).front(), graph.task(graph.tasksOf(1).front()).type2_predecessor);
  EXPECT_TRUE(graph.release(1).empty());
  graph.complete(graph.tasksOf(2).front());
  EXPECT_EQ(graph.tasksOf(1), graph.release(1));
  graph.complete(graph.tasksOf(1).front());
  EXPECT_TRUE(graph.isFinished());
  EXPECT_EQ((Configuration{{0, 0}, {0, 2}, {0, 3}}), graph.configuration());
}

TEST(ReplaceRestTest, SequencesAndStatusOfWhatStaysRemain) {
  ActionDependencyGraph graph(queue());
  graph.release(2);
  graph.complete(graph.tasksOf(2)[0]);
  graph.replaceRest(graph.commitCut(), {0, 1, 2},
                    {{{0, 0}, {0, 1}, {0, 4}}, {{0, 0}, {0, 2}, {0, 4}}});
  EXPECT_EQ(1, graph.doneCount(2));
  EXPECT_EQ(2, graph.releasedCount(2));
  EXPECT_EQ(TaskStatus::Enqueued, graph.status(graph.tasksOf(2)[1]));
  EXPECT_EQ(0, graph.task(graph.tasksOf(1)[0]).sequence);
}

TEST(ReplaceRestTest, RefusesWhatDoesNotStartAtTheCut) {
  ActionDependencyGraph graph(queue());
  graph.release(1);
  EXPECT_EQ("the plan starts agent 2 in (0,2) instead of (0,3), where it rests",
            refusalOf(graph, {0, 1, 2}, {{{0, 0}, {0, 1}, {0, 2}}}));
  EXPECT_EQ("the plan does not start with one cell for each agent",
            refusalOf(graph, {0, 1, 2}, {{{0, 0}, {0, 1}}}));
  EXPECT_EQ(6, graph.taskCount()) << "a refused plan leaves the graph as it was";
}

TEST(ReplaceRestTest, RefusesToEnterACellThatALostRobotHolds) {
  ActionDependencyGraph graph(queue());
  graph.release(1);  // agent 2 is lost somewhere between (0,2) and (0,3)
  EXPECT_EQ("step 0: agent 1 enters (0,2), which agent 2 holds and does not leave by then",
            refusalOf(graph, {0, 1}, {{{0, 0}, {0, 1}}, {{0, 0}, {0, 2}}}));
  EXPECT_EQ("step 3: agent 1 enters (0,3), which agent 2 holds and does not leave by then",
            refusalOf(graph, {1}, {{{0, 1}}, {{1, 1}}, {{1, 2}}, {{1, 3}}, {{0, 3}}}));
}

TEST(ReplaceRestTest, RefusesAnOpenCut) {
  ActionDependencyGraph graph(queue());
  EXPECT_THROW(graph.replaceRest({1, 0, 0}, {0, 1, 2}, {{{0, 1}, {0, 1}, {0, 2}}}),
               std::invalid_argument);
  graph.release(1);
  EXPECT_THROW(graph.replaceRest({0, 0, 0}, {0, 1, 2}, {{{0, 0}, {0, 1}, {0, 2}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace sylph
