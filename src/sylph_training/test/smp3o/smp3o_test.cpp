#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_training/run/threads.hpp"
#include "sylph_training/smp3o/advantages.hpp"
#include "sylph_training/smp3o/rollout.hpp"
#include "sylph_training/smp3o/sequences.hpp"
#include "sylph_training/smp3o/smp3o_learner.hpp"
#include "sylph_training/smp3o/smp3o_losses.hpp"
#include "sylph_training/worlds/symmetric_worlds.hpp"

namespace sylph_training {
namespace {

sylph::NetworkShape smallShape() {
  sylph::NetworkShape shape;
  shape.near_width = 4;
  shape.far_width = 4;
  shape.goal_width = 4;
  shape.message_width = 4;
  shape.width = 16;
  shape.semantic_tokens = 4;
  return shape;
}

bool isMoved(const torch::Tensor& gradient) {
  return gradient.defined() && gradient.norm().item<double>() > 0.0;
}

TEST(AdvantagesTest, AreTheSumOfDiscountedTemporalDifferences) {
  torch::manual_seed(3);
  const int steps = 12;
  const double gamma = 0.95;
  const double lambda = 0.9;
  const torch::Tensor rewards = torch::randn({steps});
  const torch::Tensor values = torch::randn({steps + 1});
  const auto toVector = [](const torch::Tensor& numbers) {
    return std::vector<float>(numbers.data_ptr<float>(),
                              numbers.data_ptr<float>() + numbers.numel());
  };
  const std::vector<float> found =
      generalizedAdvantages(toVector(rewards), toVector(values.narrow(0, 0, steps)),
                            values[steps].item<float>(), gamma, lambda);
  for (int t = 0; t < steps; ++t) {
    double expected = 0.0;
    for (int k = t; k < steps; ++k) {
      const double delta = rewards[k].item<double>() + gamma * values[k + 1].item<double>() -
                           values[k].item<double>();
      expected += std::pow(gamma * lambda, k - t) * delta;
    }
    EXPECT_NEAR(expected, found[static_cast<std::size_t>(t)], 1e-5);
  }
  EXPECT_THROW(generalizedAdvantages({1.F}, {}, 0.F, gamma, lambda), std::invalid_argument);
}

TEST(ClippedPolicyLossTest, TakesTheWorseOfRatioAndClippedRatio) {
  // Ratios 1.5 and 0.5, each with a good and a bad advantage; the last step does not count.
  const torch::Tensor now = torch::log(torch::tensor({0.6F, 0.6F, 0.2F, 0.2F, 0.9F}));
  const torch::Tensor old = torch::log(torch::tensor({0.4F, 0.4F, 0.4F, 0.4F, 0.1F}));
  const torch::Tensor advantages = torch::tensor({1.F, -1.F, 1.F, -1.F, 100.F});
  const torch::Tensor weights = torch::tensor({1.F, 1.F, 1.F, 1.F, 0.F});
  const double expected = -(1.2 - 1.5 + 0.5 - 0.8) / 4.0;
  EXPECT_NEAR(expected, clippedPolicyLoss(now, old, advantages, weights, 0.2).item<double>(), 1e-6);
  EXPECT_EQ(0.0, clippedPolicyLoss(now, old, advantages, torch::zeros({5}), 0.2).item<double>());
}

TEST(ExpectedSvoTest, KeepsTheSvoOfWhoIsInTheMiddleOfAConflict) {
  const torch::Tensor before = torch::tensor({{1.F, 0.F}, {1.F, 0.F}, {1.F, 0.F}});
  const torch::Tensor now = torch::tensor({{0.F, 1.F}, {0.F, 1.F}, {0.F, 1.F}});
  const torch::Tensor expected = torch::tensor({{0.F, 1.F}, {0.25F, 0.75F}, {1.F, 0.F}});
  EXPECT_TRUE(
      torch::allclose(expected, expectedSvo(before, now, torch::tensor({0.F, 0.5F, 9.F}), 2.0)));
}

TEST(NormalizedTest, CountsOnlyStepsWithWeight) {
  const torch::Tensor found =
      normalized(torch::tensor({1.F, 3.F, 77.F}), torch::tensor({1.F, 1.F, 0.F}));
  EXPECT_NEAR(-1.0, found[0].item<double>(), 1e-4);
  EXPECT_NEAR(1.0, found[1].item<double>(), 1e-4);
}

/// Two agent steps with two SVO levels; logits that make probabilities easy to write down.
struct Example {
  PolicyOutput output;
  LossTargets targets;

  Example() {
    output.actions = torch::tensor({{0.F, 0.F, 0.F, 0.F, 0.F}, {2.F, 0.F, 0.F, 0.F, 0.F}});
    output.svo = torch::tensor({{0.F, 0.F}, {1.F, 0.F}});
    output.values = torch::tensor({1.F, -1.F});
    output.blocking = torch::tensor({0.F, 3.F});
    for (torch::Tensor* tensor : {&output.actions, &output.svo, &output.values, &output.blocking}) {
      tensor->requires_grad_();
    }
    targets.actions = torch::tensor({1, 0}, torch::kLong);
    targets.action_log_probs = torch::log(torch::tensor({0.2F, 0.5F}));
    targets.action_advantages = torch::tensor({2.F, -1.F});
    targets.svo_levels = torch::tensor({1, 0}, torch::kLong);
    targets.svo_log_probs = torch::log(torch::tensor({0.5F, 0.5F}));
    targets.svo_advantages = torch::tensor({3.F, 5.F});
    targets.has_svo_choice = torch::tensor({1.F, 0.F});
    targets.returns = torch::tensor({0.F, -3.F});
    targets.valid = torch::tensor({{1.F, 1.F, 1.F, 1.F, 0.F}, {1.F, 0.F, 1.F, 1.F, 1.F}});
    targets.blocks = torch::tensor({0.F, 1.F});
    targets.expected_svo = torch::tensor({{0.3F, 0.7F}, {1.F, 0.F}});
  }
};

double sigmoidEntropy(double logit, double target) {
  const double p = 1.0 / (1.0 + std::exp(-logit));
  return -(target * std::log(p) + (1.0 - target) * std::log(1.0 - p));
}

TEST(Smp3oLossesTest, AreWhatOneComputesByHand) {
  const Example example;
  const LossTerms terms = smp3oLosses(example.output, example.targets, 0.2);
  const double stay = std::exp(2.0) / (std::exp(2.0) + 4.0);
  const double move = 1.0 / (std::exp(2.0) + 4.0);
  EXPECT_NEAR(-(2.0 - std::max(stay / 0.5, 1.0)) / 2.0, terms.action_policy.item<double>(), 1e-5);
  EXPECT_NEAR(-3.0, terms.svo_policy.item<double>(), 1e-5);
  EXPECT_NEAR((1.0 + 4.0) / 2.0, terms.value.item<double>(), 1e-5);
  EXPECT_NEAR((std::log(5.0) - stay * std::log(stay) - 4.0 * move * std::log(move)) / 2.0,
              terms.action_entropy.item<double>(), 1e-5);
  EXPECT_NEAR(std::log(2.0), terms.svo_entropy.item<double>(), 1e-5);
  const double valid = 5.0 * sigmoidEntropy(0.0, 1.0) + sigmoidEntropy(2.0, 1.0) +
                       3.0 * sigmoidEntropy(0.0, 1.0) + sigmoidEntropy(0.0, 0.0);
  EXPECT_NEAR(valid / 10.0, terms.valid.item<double>(), 1e-5);
  EXPECT_NEAR((sigmoidEntropy(0.0, 0.0) + sigmoidEntropy(3.0, 1.0)) / 2.0,
              terms.blocking.item<double>(), 1e-5);
  EXPECT_NEAR(std::log(2.0), terms.stability.item<double>(), 1e-5);
  EXPECT_NEAR(0.5, terms.clipped_share, 1e-6);

  const LossWeights weights{7.0, 0.1, 0.2, 0.3, 0.4, 0.6};
  const auto number = [](const torch::Tensor& term) { return term.item<double>(); };
  EXPECT_NEAR(
      7.0 * (number(terms.action_policy) + number(terms.svo_policy)) + 0.1 * number(terms.value) -
          0.2 * (number(terms.action_entropy) + number(terms.svo_entropy)) +
          0.3 * number(terms.valid) + 0.4 * number(terms.blocking) + 0.6 * number(terms.stability),
      number(terms.total(weights)), 1e-4);
}

TEST(Smp3oLossesTest, EachTermReachesItsOwnHead) {
  const auto gradients = [](torch::Tensor LossTerms::*term) {
    const Example example;
    (smp3oLosses(example.output, example.targets, 0.2).*term).backward();
    return std::array<bool, 4>{
        isMoved(example.output.actions.grad()), isMoved(example.output.svo.grad()),
        isMoved(example.output.values.grad()), isMoved(example.output.blocking.grad())};
  };
  using Heads = std::array<bool, 4>;
  EXPECT_EQ((Heads{true, false, false, false}), gradients(&LossTerms::action_policy));
  EXPECT_EQ((Heads{false, true, false, false}), gradients(&LossTerms::svo_policy));
  EXPECT_EQ((Heads{false, false, true, false}), gradients(&LossTerms::value));
  EXPECT_EQ((Heads{true, false, false, false}), gradients(&LossTerms::action_entropy));
  EXPECT_EQ((Heads{true, false, false, false}), gradients(&LossTerms::valid));
  EXPECT_EQ((Heads{false, false, false, true}), gradients(&LossTerms::blocking));
  EXPECT_EQ((Heads{false, true, false, false}), gradients(&LossTerms::stability));
}

TEST(SequencesTest, LieSideBySideWithTheLongestFirst) {
  EpisodePiece two;
  two.agents = 2;
  two.first_rows = {0, 5, 10};
  EpisodePiece three;
  three.agents = 3;
  three.first_rows = {2, 7};
  const std::vector<Sequence> whole = cutIntoSequences({three, two}, 8);
  ASSERT_EQ(2U, whole.size());
  const SequenceLayout layout(whole);
  EXPECT_EQ((std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), layout.rows);
  EXPECT_EQ((std::vector<std::int64_t>{0, 0, 2, 2, 2, 5, 5, 7, 7, 7, 10, 10}), layout.world_rows);
  EXPECT_EQ((std::vector<std::int64_t>{5, 5, 2}), layout.step_counts);
  const std::vector<Sequence> cut = cutIntoSequences({two}, 2);
  ASSERT_EQ(2U, cut.size());
  EXPECT_EQ((std::vector<std::int64_t>{0, 5}), cut[0].first_rows);
  EXPECT_EQ((std::vector<std::int64_t>{10}), cut[1].first_rows);
}

EnvironmentBatch smallBatch(int worlds, int max_steps) {
  EnvironmentOptions options;
  options.max_steps = max_steps;
  const WorldSource source = [](sylph::Rng& rng) {
    const int agents = 1 + static_cast<int>(sylph::drawIndex(rng, 3));
    return randomInstance(sylph::Grid(4, 4), agents, {}, rng);
  };
  return {source, options, {}, worlds, 11};
}

TEST(RolloutTest, IsWhatTheNetworkComputesAgainFromTheRecord) {
  torch::manual_seed(2);
  PolicyModel model(smallShape());
  RolloutCollector collector(smallBatch(3, 6), true, torch::kCPU);
  collector.collect(model, 5);  // begins in the middle of episodes below
  const Rollout rollout = collector.collect(model, 20);
  ASSERT_EQ(rollout.values.size(0), rollout.rowCount());
  std::vector<int> seen(static_cast<std::size_t>(rollout.rowCount()), 0);
  const torch::NoGradGuard no_grad;
  for (const EpisodePiece& piece : rollout.pieces) {
    torch::Tensor memory = rollout.memory.narrow(0, piece.first_rows.front(), piece.agents).clone();
    for (const std::int64_t first : piece.first_rows) {
      const auto take = [&](const torch::Tensor& column) {
        return column.narrow(0, first, piece.agents);
      };
      PolicyInput input;
      input.views = take(rollout.views).to(torch::kFloat).permute({0, 3, 1, 2});
      input.vectors = take(rollout.vectors);
      input.svo = take(rollout.svo);
      input.memory = memory;
      const torch::Tensor partners = take(rollout.partners).contiguous();
      std::tie(input.hop1, input.hop2) = hopMatrices(
          {partners.data_ptr<std::int64_t>(), partners.data_ptr<std::int64_t>() + piece.agents});
      const PolicyOutput output = model->forward(input);
      EXPECT_TRUE(torch::allclose(output.values, take(rollout.values), 1e-4, 1e-4));
      EXPECT_TRUE(torch::allclose(torch::log_softmax(output.actions, 1)
                                      .gather(1, take(rollout.actions).unsqueeze(1))
                                      .squeeze(1),
                                  take(rollout.action_log_probs), 1e-4, 1e-4));
      memory = output.memory;
      for (std::int64_t row = first; row < first + piece.agents; ++row) {
        ++seen[static_cast<std::size_t>(row)];
      }
    }
  }
  EXPECT_EQ(std::vector<int>(seen.size(), 1), seen);
  EXPECT_FALSE(rollout.episodes.empty());
}

TEST(RolloutTest, SolvedEpisodesEndWithoutValueAndOthersWithTheirs) {
  torch::manual_seed(2);
  PolicyModel model(smallShape());
  RolloutCollector collector(smallBatch(8, 9), false, torch::kCPU);
  const Rollout rollout = collector.collect(model, 30);
  int solved = 0;
  int cut_short = 0;
  for (const EpisodePiece& piece : rollout.pieces) {
    ASSERT_EQ(piece.agents, static_cast<std::int64_t>(piece.end_values.size()));
    (piece.end_values[0] == 0.F ? solved : cut_short) += 1;
  }
  int records_solved = 0;
  for (const EpisodeRecord& record : rollout.episodes) {
    records_solved += record.is_solved ? 1 : 0;
  }
  EXPECT_EQ(records_solved, solved);
  EXPECT_GT(cut_short, 0);
  EXPECT_EQ(0.0, rollout.memory.abs().max().item<double>());
}

TEST(Smp3oLearnerTest, LearnsToWalkToTheGoal) {
  useThreads(1);
  torch::manual_seed(5);
  const WorldSource corridor = [](sylph::Rng& rng) {
    const int start = static_cast<int>(sylph::drawIndex(rng, 6));
    const int goal = (start + 3) % 6;
    return sylph::Instance{sylph::Grid(1, 6), {{0, start}}, {{0, goal}}, {}};
  };
  EnvironmentOptions environment;
  environment.max_steps = 20;
  PolicyModel model(smallShape());
  RolloutCollector collector(EnvironmentBatch(corridor, environment, {}, 16, 1), true, torch::kCPU);
  Smp3oLearnerOptions options;
  options.learning_rate = 3e-3;
  options.epochs = 3;
  options.minibatch_rows = 64;
  options.sequence_length = 4;
  Smp3oLearner learner(model, options, torch::kCPU);
  sylph::Rng rng(2);
  const auto meanSteps = [](const Rollout& rollout) {
    double steps = 0.0;
    for (const EpisodeRecord& record : rollout.episodes) {
      steps += record.steps;
    }
    return steps / static_cast<double>(rollout.episodes.size());
  };
  const double at_first = meanSteps(collector.collect(learner.model(), 32));
  double at_last = 0.0;
  for (int iteration = 0; iteration < 15; ++iteration) {
    const Rollout rollout = collector.collect(learner.model(), 16);
    learner.update(rollout, rng);
    at_last = meanSteps(rollout);
  }
  EXPECT_GT(at_first, 6.0);
  EXPECT_LT(at_last, 4.5);
}

TEST(Smp3oLearnerTest, TeachesTheCriticAlone) {
  torch::manual_seed(5);
  PolicyModel model(smallShape());
  const sylph::TensorFile before = exportWeights(model);
  RolloutCollector collector(smallBatch(4, 20), true, torch::kCPU);
  Smp3oLearnerOptions options;
  options.learning_rate = 1e-2;
  options.epochs = 3;
  options.only_critic = true;
  Smp3oLearner learner(model, options, torch::kCPU);
  sylph::Rng rng(2);
  const Rollout rollout = collector.collect(learner.model(), 10);
  const double at_first = learner.update(rollout, rng).value;
  EXPECT_LT(learner.update(rollout, rng).value, at_first);
  for (const auto& [name, tensor] : exportWeights(model).tensors) {
    const bool is_critics =
        name.rfind("heads.value", 0) == 0 || name.rfind("heads.blocking", 0) == 0;
    EXPECT_EQ(!is_critics, tensor.values == before.tensors.at(name).values) << name;
  }
}

TEST(Smp3oLearnerTest, GradientsGoBackThroughTheMemoryOnlyAsFarAsAsked) {
  const auto weightAfter = [](int sequence_length) {
    torch::manual_seed(5);
    PolicyModel model(smallShape());
    RolloutCollector collector(smallBatch(4, 20), true, torch::kCPU);
    Smp3oLearnerOptions options;
    options.learning_rate = 1e-3;
    options.epochs = 1;
    options.minibatch_rows = 100000;
    options.sequence_length = sequence_length;
    Smp3oLearner learner(model, options, torch::kCPU);
    sylph::Rng rng(2);
    learner.update(collector.collect(learner.model(), 10), rng);
    return exportWeights(model).tensors.at("goal.weight").values;
  };
  EXPECT_EQ(weightAfter(1), weightAfter(1));
  EXPECT_NE(weightAfter(1), weightAfter(5));
}

TEST(Smp3oLearnerTest, RefusesOptionsOutOfRange) {
  Smp3oLearnerOptions options;
  options.gamma = 1.5;
  EXPECT_THROW(Smp3oLearner(PolicyModel(smallShape()), options, torch::kCPU),
               std::invalid_argument);
  options.gamma = 0.95;
  options.epochs = 0;
  EXPECT_THROW(Smp3oLearner(PolicyModel(smallShape()), options, torch::kCPU),
               std::invalid_argument);
}

}  // namespace
}  // namespace sylph_training
