#include <gtest/gtest.h>

#include "sylph_core/social/precedence.hpp"
#include "sylph_training/imitation/reactive_scenes.hpp"
#include "sylph_training/imitation/reactive_teacher.hpp"
#include "test/support/random_weights.hpp"

namespace sylph_training {
namespace {

using sylph::Action;

/// Two who want past each other, with a junction behind the second one.
sylph::Instance corridor() {
  return {sylph::Grid::fromText("####.##\n"
                                ".......\n"
                                "#######\n"),
          {{1, 2}, {1, 3}},
          {{1, 6}, {1, 0}},
          {}};
}

sylph::Instance dense(sylph::Rng& rng) {
  WorldSettings settings;
  settings.side = settings.usual_side = {12, 14};
  settings.random.team_share = settings.room.team_share = settings.maze.team_share = {0.1, 0.2};
  return sampleWorld(settings, rng);
}

TEST(TeamStateTest, CountsWaitingAndTellsWhatComesCloser) {
  const sylph::Instance instance = corridor();
  const sylph::SearchProblem problem(instance);
  TeamState team(instance, problem, {0.5F, 0.25F});
  EXPECT_TRUE(team.isGreedy(0, Action::East));
  EXPECT_FALSE(team.isGreedy(0, Action::West));
  EXPECT_FALSE(team.isValid(0, Action::North));
  EXPECT_FALSE(team.isGreedy(0, Action::Stay));
  team.move({Action::West, Action::West}, team.states().svo_deg);
  EXPECT_EQ((sylph::Configuration{{1, 1}, {1, 2}}), team.states().cells);
  EXPECT_EQ(instance.starts, team.before());
  EXPECT_EQ((std::vector<int>{2, 2}), team.states().priorities);
  team.move({Action::West, Action::West}, team.states().svo_deg);
  team.move({Action::Stay, Action::Stay}, team.states().svo_deg);
  EXPECT_EQ((std::vector<Action>{Action::Stay, Action::Stay}), team.states().last_moves);
  EXPECT_FLOAT_EQ(sylph::svoByPriority(4, 0.25F), team.states().svo_deg[1]);
}

TEST(ReactiveTeacherTest, WhoIsMoreProsocialBacksOut) {
  const sylph::Instance instance = corridor();
  const sylph::SearchProblem problem(instance);
  sylph::Rng rng(1);
  const TeamState team(instance, problem, {0.F, 0.F});
  ReactiveTeacher teacher(problem, rng);
  EXPECT_EQ((std::vector<Action>{Action::East, Action::East}),
            teacher.desiredActions(team, {5.F, 40.F}));
}

TEST(ReactiveTeacherTest, SolvesDenseWorldsInTheOrderOfWaiting) {
  int solved = 0;
  constexpr int kWorlds = 20;
  for (std::uint32_t seed = 0; seed < kWorlds; ++seed) {
    sylph::Rng rng(seed);
    const sylph::Instance instance = dense(rng);
    const sylph::SearchProblem problem(instance);
    std::vector<float> tie_breaks;
    tie_breaks.reserve(instance.starts.size());
    for (int agent = 0; agent < instance.agentCount(); ++agent) {
      tie_breaks.push_back(static_cast<float>(sylph::drawFraction(rng)));
    }
    TeamState team(instance, problem, tie_breaks);
    ReactiveTeacher teacher(problem, rng);
    for (int step = 0; step < 300 && !team.isSolved(); ++step) {
      const std::vector<float> svo_deg = team.states().svo_deg;
      team.move(teacher.desiredActions(team, svo_deg), svo_deg);
    }
    solved += team.isSolved() ? 1 : 0;
  }
  EXPECT_GE(solved, kWorlds * 3 / 4);
}

TEST(ReactiveTeacherTest, APolicysTasteDecidesBetweenEquallyShortMoves) {
  const sylph::Instance instance{sylph::Grid(3, 3), {{0, 0}}, {{2, 2}}, {}};
  const sylph::SearchProblem problem(instance);
  sylph::Rng rng(1);
  const TeamState team(instance, problem, {0.F});
  ReactiveTeacher teacher(problem, rng);
  for (const Action favourite : {Action::East, Action::South}) {
    sylph::AgentRows logits = sylph::AgentRows::Zero(1, sylph::kActionCount);
    logits(0, static_cast<Eigen::Index>(favourite)) = 6.F;
    logits(0, static_cast<Eigen::Index>(Action::Stay)) = 9.F;  // no shorter: does not count
    EXPECT_EQ(std::vector<Action>{favourite},
              teacher.desiredActions(team, team.states().svo_deg, &logits));
  }
}

void expectSound(const SceneStore& store) {
  ASSERT_GT(store.sampleCount(), 0U);
  for (std::size_t scene = 0; scene < store.sceneCount(); ++scene) {
    for (const Sample& sample : store.samples(scene)) {
      int votes = 0;
      for (std::size_t action = 0; action < sylph::kActionCount; ++action) {
        votes += sample.votes[action];
        EXPECT_TRUE(sample.votes[action] == 0 || sample.regrets[action] != kImpossible);
        EXPECT_LE(sample.votes[action], sample.votes[sample.action]);
      }
      EXPECT_EQ(4, votes);
    }
  }
}

TEST(ReactiveScenesTest, HaveTheVotesOfFourDrawsWhoeverLeads) {
  sylph::Rng rng(3);
  const sylph::Instance instance = dense(rng);
  SceneStore teacher_led;
  EXPECT_TRUE(teacherLedScenes({})(instance, rng, teacher_led));
  expectSound(teacher_led);
  SceneStore student_led;
  EXPECT_TRUE(studentLedScenes(sylph::randomPolicy(), {})(instance, rng, student_led));
  expectSound(student_led);
  ReactiveSettings small;
  small.most_agents = 1;
  SceneStore none;
  EXPECT_FALSE(studentLedScenes(sylph::randomPolicy(), small)(instance, rng, none));
  EXPECT_EQ(0U, none.sampleCount());
}

TEST(DrawDesiredActionsTest, AreDrawnFromTheLogitsAndHitNoObstacle) {
  const sylph::Instance instance = corridor();
  const sylph::SearchProblem problem(instance);
  const TeamState team(instance, problem, {0.F, 0.F});
  sylph::AgentRows logits = sylph::AgentRows::Zero(2, sylph::kActionCount);
  logits(0, static_cast<Eigen::Index>(Action::North)) = 100.F;  // an obstacle
  logits(0, static_cast<Eigen::Index>(Action::East)) = 1.F;
  sylph::Rng rng(1);
  int east = 0;
  constexpr int kDraws = 4000;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Action desired = drawDesiredActions(team, logits, 1.0, rng)[0];
    ASSERT_TRUE(team.isValid(0, desired));
    east += desired == Action::East ? 1 : 0;
  }
  const double expected = std::exp(1.0) / (std::exp(1.0) + 2.0);    // beside Stay and West
  EXPECT_NEAR(expected, static_cast<double>(east) / kDraws, 0.03);  // four standard errors
}

}  // namespace
}  // namespace sylph_training
