#include "sylph_training/worlds/environment_batch.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_training/worlds/symmetric_worlds.hpp"

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::Rng;

/// Teams of one to five in an open room.
sylph::Instance room(Rng& rng) {
  const auto agents = 1 + static_cast<int>(sylph::drawIndex(rng, 5));
  return randomInstance(sylph::Grid(5, 5), agents, {}, rng);
}

std::vector<Action> randomActions(EnvironmentBatch& batch) {
  std::vector<Action> actions;
  for (int world = 0; world < batch.worldCount(); ++world) {
    for (int agent = 0; agent < batch.world(world).instance().agentCount(); ++agent) {
      actions.push_back(
          sylph::kActions[sylph::drawIndex(batch.rngOfWorld(world), sylph::kActionCount)]);
    }
  }
  return actions;
}

torch::Tensor evenSvos(const EnvironmentBatch& batch) {
  return torch::full({batch.rowCount(), sylph::kSvoLevelCount}, 0.1F);
}

EnvironmentBatch batchOf(const SvoOptions& svo, int worlds = 4, std::uint32_t seed = 7) {
  EnvironmentOptions options;
  options.max_steps = 12;
  return {room, options, svo, worlds, seed};
}

TEST(EnvironmentBatchTest, RowsOfAWorldAreWhatItsEnvironmentEncodes) {
  const EnvironmentBatch batch = batchOf({});
  const PolicyInput input = batch.observe();
  const torch::Tensor views = input.views.permute({0, 2, 3, 1}).contiguous();
  ASSERT_EQ(batch.rowCount(), views.size(0));
  std::vector<float> view(sylph::kObservationSize);
  std::vector<float> vector(sylph::kVectorSize);
  for (int world = 0; world < batch.worldCount(); ++world) {
    for (int agent = 0; agent < batch.world(world).instance().agentCount(); ++agent) {
      batch.world(world).encode(agent, view.data(), vector.data());
      const std::int64_t row = batch.firstRows()[static_cast<std::size_t>(world)] + agent;
      EXPECT_TRUE(torch::equal(torch::tensor(view), views[row].flatten()));
      EXPECT_TRUE(torch::equal(torch::tensor(vector), input.vectors[row]));
    }
  }
}

TEST(EnvironmentBatchTest, PartnersStayWithinTheirWorld) {
  EnvironmentBatch batch = batchOf({});
  for (int step = 0; step < 30; ++step) {
    const auto partners = batch.partnerRows();
    for (std::size_t world = 0; world + 1 < batch.firstRows().size(); ++world) {
      const std::int64_t first = batch.firstRows()[world];
      const std::int64_t end = batch.firstRows()[world + 1];
      for (std::int64_t row = first; row < end; ++row) {
        EXPECT_GE(partners[static_cast<std::size_t>(row)], first);
        EXPECT_LT(partners[static_cast<std::size_t>(row)], end);
      }
    }
    batch.step(randomActions(batch), evenSvos(batch));
    batch.resetFinished();
  }
}

TEST(EnvironmentBatchTest, TheSameSeedGivesTheSameEpisodesWhateverTheOtherWorldsDo) {
  const auto rewardsOfFirstWorld = [](int worlds, std::uint32_t seed) {
    EnvironmentBatch batch = batchOf({}, worlds, seed);
    std::vector<float> rewards;
    for (int step = 0; step < 40; ++step) {
      const BatchStep outcome = batch.step(randomActions(batch), evenSvos(batch));
      rewards.insert(rewards.end(), outcome.action_rewards.begin(),
                     outcome.action_rewards.begin() + batch.firstRows()[1]);
      batch.resetFinished();
    }
    return rewards;
  };
  EXPECT_EQ(rewardsOfFirstWorld(3, 5), rewardsOfFirstWorld(3, 5));
  EXPECT_NE(rewardsOfFirstWorld(3, 5), rewardsOfFirstWorld(3, 6));
}

TEST(EnvironmentBatchTest, NewEpisodesBeginWhereOldOnesEnd) {
  EnvironmentBatch batch = batchOf({});
  int ended = 0;
  for (int step = 0; step < 60; ++step) {
    const std::vector<std::int64_t> rows_before = batch.firstRows();
    const BatchStep outcome = batch.step(randomActions(batch), evenSvos(batch));
    const auto carried = batch.resetFinished();
    ASSERT_EQ(batch.rowCount(), static_cast<std::int64_t>(carried.size()));
    for (std::size_t world = 0; world < outcome.is_finished.size(); ++world) {
      const auto first = static_cast<std::size_t>(batch.firstRows()[world]);
      const bool is_new = outcome.is_finished[world] != 0;
      EXPECT_EQ(is_new ? -1 : rows_before[world], carried[first]);
      EXPECT_FALSE(batch.world(static_cast<int>(world)).isFinished());
      ended += is_new ? 1 : 0;
    }
  }
  const std::vector<EpisodeRecord> records = batch.takeRecords();
  EXPECT_EQ(ended, static_cast<int>(records.size()));
  EXPECT_GE(ended, 4 * 60 / 12 - 4);
  for (const EpisodeRecord& record : records) {
    EXPECT_TRUE(record.is_solved ? record.arrived == record.agents : record.steps == 12);
    EXPECT_LT(record.external_reward, 0.0);
  }
  EXPECT_TRUE(batch.takeRecords().empty());
}

TEST(EnvironmentBatchTest, OnAGoalTheLearnedSvoIsTheMostProsocialAndNoChoice) {
  const WorldSource parked = [](Rng&) {
    return sylph::Instance{sylph::Grid(1, 4), {{0, 0}, {0, 1}}, {{0, 0}, {0, 3}}, {}};
  };
  EnvironmentBatch batch(parked, {}, {SvoMode::Learned, SvoFeedback::Sample}, 1, 0);
  EXPECT_EQ(1.F, batch.observe().svo[0][sylph::kMostProsocialLevel].item<float>());
  torch::Tensor selfish = torch::zeros({2, sylph::kSvoLevelCount});
  selfish.select(1, 0).fill_(1.F);
  const BatchStep step = batch.step({Action::Stay, Action::Stay}, selfish);
  EXPECT_EQ((std::vector<std::int64_t>{sylph::kMostProsocialLevel, 0}), step.svo_levels);
  EXPECT_EQ((std::vector<float>{0.F, 1.F}), step.has_svo_choice);
  EXPECT_TRUE(torch::equal(torch::tensor(step.svo).view({2, -1}), batch.observe().svo));
}

TEST(EnvironmentBatchTest, FeedsBackTheSampleOrTheDistribution) {
  const auto stepOf = [](SvoFeedback feedback) {
    EnvironmentBatch batch([](Rng&) { return recessWorld(7, 2); }, {}, {SvoMode::Learned, feedback},
                           1, 3);
    return batch.step({Action::Stay, Action::Stay}, evenSvos(batch));
  };
  const BatchStep sampled = stepOf(SvoFeedback::Sample);
  EXPECT_EQ(1.F, sampled.svo[static_cast<std::size_t>(sampled.svo_levels[0])]);
  EXPECT_EQ(1.F, std::accumulate(sampled.svo.begin(), sampled.svo.begin() + 10, 0.F));
  EXPECT_EQ(std::vector<float>(20, 0.1F), stepOf(SvoFeedback::Distribution).svo);
}

TEST(EnvironmentBatchTest, AblationsDrawSvosAsOftenAsTheyAreCalled) {
  const auto changes = [](SvoMode mode) {
    EnvironmentOptions options;
    options.max_steps = 1000;
    EnvironmentBatch batch([](Rng&) { return recessWorld(7, 2); }, options,
                           {mode, SvoFeedback::Sample}, 1, 3);
    std::vector<std::int64_t> before;
    int changed = 0;
    for (int step = 0; step < 50; ++step) {
      // Apart from each other, so that they stay partners.
      const BatchStep outcome = batch.step({Action::Stay, Action::Stay}, evenSvos(batch));
      EXPECT_EQ((std::vector<float>{0.F, 0.F}), outcome.has_svo_choice);
      changed += !before.empty() && before != outcome.svo_levels ? 1 : 0;
      before = outcome.svo_levels;
      if (mode == SvoMode::Off) {
        EXPECT_EQ((std::vector<std::int64_t>{0, 0}), outcome.svo_levels);
        EXPECT_EQ((std::vector<std::int64_t>{0, 1}), batch.partnerRows());
      }
    }
    return changed;
  };
  EXPECT_GT(changes(SvoMode::RandomPerStep), 40);
  EXPECT_EQ(0, changes(SvoMode::RandomPerEpisode));
  EXPECT_EQ(0, changes(SvoMode::RandomPerPartner));
  EXPECT_EQ(0, changes(SvoMode::Off));
}

TEST(EnvironmentBatchTest, AChangeOfPartnerDrawsANewSvoIfAsked) {
  EnvironmentOptions options;
  options.max_steps = 1000;
  const WorldSource crowd = [](Rng& rng) { return randomInstance(sylph::Grid(6, 6), 8, {}, rng); };
  EnvironmentBatch batch(crowd, options, {SvoMode::RandomPerPartner, SvoFeedback::Sample}, 1, 9);
  std::vector<std::int64_t> partners_before;
  std::vector<std::int64_t> levels_before;
  int new_levels = 0;
  for (int step = 0; step < 60 && !batch.world(0).isFinished(); ++step) {
    const std::vector<std::int64_t> partners = batch.partnerRows();
    const BatchStep outcome = batch.step(randomActions(batch), evenSvos(batch));
    for (std::size_t row = 0; row < partners.size() && step > 0; ++row) {
      if (outcome.svo_levels[row] != levels_before[row]) {
        EXPECT_NE(partners_before[row], partners[row]);
        ++new_levels;
      }
    }
    partners_before = partners;
    levels_before = outcome.svo_levels;
  }
  EXPECT_GT(new_levels, 10);
}

TEST(EnvironmentBatchTest, RefusesWhatItCannotBeAsked) {
  EXPECT_THROW(batchOf({}, 0), std::invalid_argument);
  EnvironmentBatch batch = batchOf({});
  EXPECT_THROW(batch.step({}, evenSvos(batch)), std::invalid_argument);
  EXPECT_THROW(batch.step(randomActions(batch), torch::zeros({1, 10})), std::invalid_argument);
}

TEST(DrawFromTest, DrawsInProportion) {
  Rng rng(1);
  const std::vector<float> probabilities = {1.F, 0.F, 3.F};
  std::vector<int> drawn(3, 0);
  for (int draw = 0; draw < 4000; ++draw) {
    ++drawn[static_cast<std::size_t>(drawFrom(probabilities.data(), 3, rng))];
  }
  EXPECT_NEAR(1000, drawn[0], 100);
  EXPECT_EQ(0, drawn[1]);
}

}  // namespace
}  // namespace sylph_training
