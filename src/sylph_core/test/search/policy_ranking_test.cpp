#include "sylph_core/search/policy_ranking.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "sylph_core/grid/action.hpp"

namespace sylph {
namespace {

/// At the start.
Occupants occupantsOf(const SearchProblem& problem) {
  Occupants occupants(static_cast<std::size_t>(problem.graph.size()), kNoAgent);
  for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
    occupants[static_cast<std::size_t>(problem.starts[static_cast<std::size_t>(agent)])] = agent;
  }
  return occupants;
}

// One agent in the middle of a free map, its goal to the east; another one beside it, to the north.
class PolicyRankingTest : public ::testing::Test {
 protected:
  /// Actions in the order in which the first agent tries them.
  std::vector<Action> ranked(const MoveSettings& settings) {
    PolicyRanking ranking(problem_, settings, actions_, priorities_, rng_);
    const VertexId at = problem_.starts[0];
    Moves moves = movesFrom(problem_.graph, at);
    ranking.rank(0, at, occupantsOf(problem_), moves);
    std::vector<Action> order;
    for (int index = 0; index < moves.count; ++index) {
      const VertexId target = moves.targets[static_cast<std::size_t>(index)];
      order.push_back(*actionBetween(problem_.graph.cellAt(at), problem_.graph.cellAt(target)));
    }
    return order;
  }

  Instance instance_{Grid(5, 5), {{2, 2}, {1, 2}}, {{2, 4}, {0, 0}}, {}};
  SearchProblem problem_{instance_};
  AgentRows actions_ = AgentRows::Zero(2, kActionCount);
  Priorities priorities_ = {0, 0};
  Rng rng_{1};
};

TEST_F(PolicyRankingTest, DistanceWeighsMoreThanAnUnsureNetwork) {
  actions_.row(0) << 3.F, 1.F, 0.F, 2.F, 4.F;  // stay, north, east, south, west
  EXPECT_EQ(
      (std::vector<Action>{Action::East, Action::Stay, Action::West, Action::South, Action::North}),
      ranked({8.0, 2.0, 0.0, 1.0, 1.0}));
}

TEST_F(PolicyRankingTest, ASureNetworkOverrulesTheDistance) {
  actions_.row(0) << 0.F, 0.F, 0.F, 0.F, 20.F;
  EXPECT_EQ(Action::West, ranked({8.0, 2.0, 0.0, 1.0, 1.0}).front());
}

TEST_F(PolicyRankingTest, StayingIsOnlyDearOffTheGoal) {
  actions_.row(0) << 1.F, 0.F, 0.F, 0.F, 0.F;
  EXPECT_EQ(Action::Stay, ranked({0.0, 2.0, 0.0, 1.0, 1.0}).back());
  instance_.goals[0] = instance_.starts[0];
  const SearchProblem home(instance_);
  const MoveSettings settings{0.0, 2.0, 0.0, 1.0, 1.0};
  PolicyRanking ranking(home, settings, actions_, priorities_, rng_);
  Moves moves;
  moves.targets = {home.graph.vertexAt({1, 2}), home.starts[0]};
  moves.count = 2;
  ranking.rank(0, home.starts[0], occupantsOf(home), moves);
  EXPECT_EQ(home.starts[0], moves.targets[0]);
}

TEST_F(PolicyRankingTest, WithoutDistanceTheFirstMoveIsADrawFromTheSoftmax) {
  actions_.row(0) << 0.F, 1.F, 0.F, -1.F, 0.5F;
  const Eigen::ArrayXf weights = actions_.row(0).array().exp();
  std::map<Action, int> drawn;
  constexpr int kDraws = 20000;
  for (int draw = 0; draw < kDraws; ++draw) {
    ++drawn[ranked({0.0, 0.0, 1.0, 1.0, 1.0}).front()];
  }
  for (const Action action : kActions) {
    const auto expected =
        static_cast<double>(weights(static_cast<Eigen::Index>(action)) / weights.sum());
    EXPECT_NEAR(expected, static_cast<double>(drawn[action]) / kDraws, 0.015);
  }
}

TEST_F(PolicyRankingTest, HighPrioritiesMakeNeighborsTryOtherThings) {
  actions_.row(0) << 0.F, 5.F, 0.F, 0.F, 0.F;
  const auto otherChoices = [&] {
    int count = 0;
    for (int draw = 0; draw < 300; ++draw) {
      count += ranked({0.0, 0.0, 2.0, 0.01, 2.0}).front() != Action::North ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(0, otherChoices());
  priorities_ = {0, 200};
  EXPECT_GT(otherChoices(), 30);
  priorities_ = {200, 0};
  EXPECT_GT(otherChoices(), 30);
}

}  // namespace
}  // namespace sylph
