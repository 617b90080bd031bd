#include "sylph_core/policy/policy_rollout.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "sylph_core/social/precedence.hpp"
#include "sylph_core/social/svo.hpp"
#include "test/support/random_weights.hpp"

namespace sylph {
namespace {

// 0 and 1 want past each other in a corridor, 2 is on its goal.
class PolicyRolloutTest : public ::testing::Test {
 protected:
  PolicyRollout rollout(SvoChoice choice = SvoChoice::Mean, int threads = 1) const {
    Rng rng(7);  // the same tie breaks each time
    return {*policy_, grid_, distances_, choice, threads, rng};
  }
  PolicyStep firstStep(PolicyRollout& rollout) {
    return rollout.follow(rollout.nothingKnown(), starts_, starts_, rng_);
  }

  Grid grid_ = Grid::fromText(
      ".....\n"
      "#.#.#\n"
      ".....\n");
  Configuration starts_ = {{0, 0}, {0, 4}, {2, 2}};
  std::vector<DistanceField> distances_ = distancesTo({{0, 4}, {0, 0}, {2, 2}}, grid_);
  Configuration next_ = {{0, 1}, {0, 4}, {2, 2}};
  std::shared_ptr<const Policy> policy_ = randomPolicy();
  Rng rng_{1};
};

TEST_F(PolicyRolloutTest, PartnersAreWhoCrossesOnesWay) {
  auto walk = rollout();
  const PolicyStep step = firstStep(walk);
  EXPECT_EQ((std::vector<AgentId>{1, 0, 2}), step.social.partners);
  EXPECT_EQ(1, walk.calls());
}

TEST_F(PolicyRolloutTest, SvosAreMeanAnglesAndFortyFiveDegreesOnTheGoal) {
  auto walk = rollout();
  const PolicyStep step = firstStep(walk);
  ASSERT_EQ(3U, step.social.svo_deg.size());
  for (int agent = 0; agent < 2; ++agent) {
    std::vector<float> probabilities(kSvoLevelCount);
    for (int level = 0; level < kSvoLevelCount; ++level) {
      probabilities[static_cast<std::size_t>(level)] = step.svo(agent, level);
    }
    EXPECT_NEAR(1.F, step.svo.row(agent).sum(), 1e-5F);
    EXPECT_FLOAT_EQ(static_cast<float>(meanSvo(probabilities)),
                    step.social.svo_deg[static_cast<std::size_t>(agent)]);
  }
  EXPECT_EQ(45.F, step.social.svo_deg[2]);
  EXPECT_EQ(1.F, step.svo(2, kMostProsocialLevel));
}

TEST_F(PolicyRolloutTest, SampledSvosAreLevelsInProportion) {
  auto walk = rollout(SvoChoice::Sample);
  double sum_deg = 0.0;
  double mean_deg = 0.0;
  constexpr int kDraws = 2000;
  for (int draw = 0; draw < kDraws; ++draw) {
    const PolicyStep step = firstStep(walk);
    const float svo_deg = step.social.svo_deg[0];
    EXPECT_EQ(0.0, std::fmod(svo_deg, kSvoLevelSpacingDeg));
    sum_deg += svo_deg;
    for (int level = 0; draw == 0 && level < kSvoLevelCount; ++level) {
      mean_deg += step.svo(0, level) * svoOfLevel(level);
    }
  }
  EXPECT_NEAR(mean_deg, sum_deg / kDraws, 1.5);  // four standard errors
}

TEST_F(PolicyRolloutTest, AStepDependsOnTheOneBeforeAndOnNothingElse) {
  auto walk = rollout();
  const PolicyStep first = firstStep(walk);
  const PolicyStep second = walk.follow(first, starts_, next_, rng_);
  walk.follow(second, next_, starts_, rng_);  // the search goes elsewhere and comes back
  const PolicyStep again = walk.follow(first, starts_, next_, rng_);
  EXPECT_EQ(second.actions, again.actions);
  EXPECT_EQ(second.svo, again.svo);
  EXPECT_EQ(second.social.partners, again.social.partners);
  const PolicyStep fresh = walk.follow(walk.nothingKnown(), starts_, next_, rng_);
  EXPECT_NE(second.actions, fresh.actions);
}

TEST_F(PolicyRolloutTest, MemoryIsFedBackOnlyIfTheWeightsSaySo) {
  auto walk = rollout();
  const PolicyStep first = firstStep(walk);
  EXPECT_EQ(0, first.memory.size());

  TensorFile weights = RandomWeights(smallShape(), 1).file();
  weights.metadata["memory"] = "true";
  policy_ = std::make_shared<const Policy>(weights, "with memory");
  auto remembering = rollout();
  const PolicyStep same = firstStep(remembering);
  EXPECT_EQ(first.actions, same.actions) << "the memory is 0 at the start";
  EXPECT_EQ(3, same.memory.rows());
  EXPECT_NE(walk.follow(first, starts_, next_, rng_).actions,
            remembering.follow(same, starts_, next_, rng_).actions);
}

TEST_F(PolicyRolloutTest, ThreadsChangeNothing) {
  grid_ = Grid(10, 10);
  starts_.clear();
  Configuration goals;
  for (int index = 0; index < 40; ++index) {
    starts_.push_back(grid_.cellAt(index));
    goals.push_back(grid_.cellAt(99 - index));
  }
  distances_ = distancesTo(goals, grid_);
  auto alone = rollout();
  auto together = rollout(SvoChoice::Mean, 3);
  EXPECT_EQ(firstStep(alone).actions, firstStep(together).actions);
}

TEST_F(PolicyRolloutTest, WithoutACostNetworkASearchIsToldWhatTheOthersAre) {
  auto walk = rollout();
  const PolicyStep step = firstStep(walk);
  EXPECT_EQ(step.actions, step.by_cost);
}

TEST_F(PolicyRolloutTest, ACostNetworkTellsASearchAndChangesNothingElse) {
  const TensorFile weights = RandomWeights(smallShape(), 1).file();
  policy_ = std::make_shared<const Policy>(weights, "policy");
  auto alone = rollout();
  const PolicyStep without = firstStep(alone);
  const TensorFile other = RandomWeights(smallShape(), 2).file();
  policy_ = std::make_shared<const Policy>(other, "cost network");
  auto by_other = rollout();
  const PolicyStep cost = firstStep(by_other);
  policy_ = std::make_shared<const Policy>(withCostNetwork(weights, other), "both");
  auto both = rollout();
  const PolicyStep step = firstStep(both);
  EXPECT_EQ(without.actions, step.actions);
  EXPECT_EQ(without.svo, step.svo);
  EXPECT_EQ(cost.actions, step.by_cost);
  EXPECT_NE(without.by_cost, step.by_cost);
  const PolicyStep social =
      both.follow(both.nothingKnown(), starts_, starts_, rng_, StepUse::Social);
  EXPECT_EQ(without.by_cost, social.by_cost) << "not asked";
}

TEST_F(PolicyRolloutTest, WeightsThatOverflowSayNothing) {
  TensorFile weights = RandomWeights(smallShape(), 1).file();
  weights.tensors["heads.action.bias"].values[2] = std::numeric_limits<float>::infinity();
  weights.tensors["heads.svo.bias"].values[0] = std::numeric_limits<float>::quiet_NaN();
  policy_ = std::make_shared<const Policy>(withCostNetwork(weights, weights), "overflowing");
  auto walk = rollout();
  const PolicyStep step = firstStep(walk);
  EXPECT_TRUE(step.actions.isZero());
  EXPECT_TRUE(step.by_cost.isZero());
  EXPECT_FLOAT_EQ(22.5F, step.social.svo_deg[0]);
}

TEST_F(PolicyRolloutTest, CountsTheTimestepsOffTheGoal) {
  auto walk = rollout();
  const PolicyStep first = firstStep(walk);
  EXPECT_EQ((std::vector<int>{1, 1, 0}), first.priorities);
  const PolicyStep second = walk.follow(first, starts_, next_, rng_);
  EXPECT_EQ((std::vector<int>{2, 2, 0}), second.priorities);
  const Configuration home = {{0, 1}, {0, 0}, {2, 2}};
  EXPECT_EQ((std::vector<int>{3, 0, 0}), walk.follow(second, next_, home, rng_).priorities);
}

TEST_F(PolicyRolloutTest, SvosByWaitingAreThoseOfTheRule) {
  auto walk = rollout(SvoChoice::Priority);
  PolicyStep step = firstStep(walk);
  for (int timestep = 1; timestep < 30; ++timestep) {
    step = walk.follow(step, starts_, starts_, rng_);
  }
  for (std::size_t agent = 0; agent < 2; ++agent) {
    EXPECT_FLOAT_EQ(svoByPriority(30, walk.tieBreaks()[agent]), step.social.svo_deg[agent]);
  }
  EXPECT_EQ(45.F, step.social.svo_deg[2]);
}

TEST_F(PolicyRolloutTest, RandomSvosAreLevelsDrawnAtEachStep) {
  auto walk = rollout(SvoChoice::RandomPerStep);
  std::map<float, int> counts;
  PolicyStep step = walk.nothingKnown();
  constexpr int kDraws = 1000;
  for (int draw = 0; draw < kDraws; ++draw) {
    step = walk.follow(step, starts_, starts_, rng_);
    ++counts[step.social.svo_deg[0]];
    EXPECT_EQ(45.F, step.social.svo_deg[2]) << "on its goal";
  }
  EXPECT_EQ(static_cast<std::size_t>(kSvoLevelCount), counts.size());
  for (const auto& [svo_deg, count] : counts) {
    EXPECT_EQ(0.0, std::fmod(svo_deg, kSvoLevelSpacingDeg));
    EXPECT_NEAR(kDraws / kSvoLevelCount, count, 40);  // four standard errors
  }
}

TEST_F(PolicyRolloutTest, RandomSvosOfAnEpisodeStayAndAreAnothersInAnother) {
  std::set<float> drawn;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    PolicyRollout walk(*policy_, grid_, distances_, SvoChoice::RandomPerEpisode, 1, rng);
    const PolicyStep first = firstStep(walk);
    const PolicyStep second = walk.follow(first, starts_, next_, rng_);
    EXPECT_EQ(first.social.svo_deg, second.social.svo_deg);
    EXPECT_EQ(45.F, first.social.svo_deg[2]) << "on its goal";
    drawn.insert(first.social.svo_deg[0]);
  }
  EXPECT_GT(drawn.size(), 4U);
}

TEST_F(PolicyRolloutTest, RandomSvosOfAPartnerAreDrawnAnewWithAnotherPartner) {
  auto walk = rollout(SvoChoice::RandomPerPartner);
  const PolicyStep first = firstStep(walk);
  ASSERT_EQ(1, first.social.partners[0]);
  PolicyStep before = first;
  std::set<float> with_another;
  for (int draw = 0; draw < 20; ++draw) {
    EXPECT_EQ(first.social.svo_deg, walk.follow(first, starts_, starts_, rng_).social.svo_deg);
    before.social.partners[0] = 2;
    const PolicyStep step = walk.follow(before, starts_, starts_, rng_);
    ASSERT_EQ(1, step.social.partners[0]);
    EXPECT_EQ(first.social.svo_deg[1], step.social.svo_deg[1]) << "keeps its partner";
    with_another.insert(step.social.svo_deg[0]);
  }
  EXPECT_GT(with_another.size(), 4U);
}

TEST_F(PolicyRolloutTest, TheNetworkSeesAssignedSvosAndNotItsOwn) {
  auto learned = rollout();
  auto random = rollout(SvoChoice::RandomPerEpisode);
  const PolicyStep step = firstStep(random);
  EXPECT_FLOAT_EQ(1.F, step.svo(0, static_cast<int>(step.social.svo_deg[0] / kSvoLevelSpacingDeg)));
  EXPECT_NE(firstStep(learned).actions, step.actions);
}

TEST_F(PolicyRolloutTest, TheSvosOfTheStepBeforeDecideWhatIsSeen) {
  auto walk = rollout();
  PolicyStep before = walk.nothingKnown();
  const PolicyStep step = walk.follow(before, starts_, next_, rng_);
  spreadOverLevels(5.F, before.svo.row(0).data());
  before.social.svo_deg[0] = 5.F;
  EXPECT_NE(step.actions, walk.follow(before, starts_, next_, rng_).actions);
}

TEST_F(PolicyRolloutTest, RefusesAnotherNumberOfAgents) {
  auto walk = rollout();
  EXPECT_THROW(walk.follow(walk.nothingKnown(), starts_, {{0, 0}}, rng_), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
