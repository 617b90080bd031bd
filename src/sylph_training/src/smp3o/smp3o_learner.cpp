#include "sylph_training/smp3o/smp3o_learner.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "sylph_training/smp3o/advantages.hpp"

namespace sylph_training {
namespace {

void require(bool is_valid, const std::string& member, double value, const std::string& allowed) {
  if (!is_valid) {
    throw std::invalid_argument(member + " = " + std::to_string(value) + ": must be " + allowed);
  }
}

torch::Tensor toTensor(const std::vector<std::int64_t>& values) {
  return torch::tensor(values, torch::kLong);
}

/// Advantages of all rows, from the rewards in one column.
torch::Tensor advantagesFrom(const torch::Tensor& rewards, const Rollout& rollout,
                             const Smp3oLearnerOptions& options) {
  torch::Tensor advantages = torch::zeros_like(rollout.values);
  const torch::Tensor held_rewards = rewards.contiguous();
  const torch::Tensor held_values = rollout.values.contiguous();
  const auto* reward = held_rewards.data_ptr<float>();
  const auto* value = held_values.data_ptr<float>();
  auto* advantage = advantages.data_ptr<float>();
  for (const EpisodePiece& piece : rollout.pieces) {
    for (std::int64_t agent = 0; agent < piece.agents; ++agent) {
      std::vector<float> agent_rewards;
      std::vector<float> agent_values;
      for (const std::int64_t first_row : piece.first_rows) {
        agent_rewards.push_back(reward[first_row + agent]);
        agent_values.push_back(value[first_row + agent]);
      }
      const std::vector<float> found = generalizedAdvantages(
          agent_rewards, agent_values, piece.end_values[static_cast<std::size_t>(agent)],
          options.gamma, options.lambda);
      for (std::size_t step = 0; step < found.size(); ++step) {
        advantage[piece.first_rows[step] + agent] = found[step];
      }
    }
  }
  return advantages;
}

/// Adds up the losses of the updates.
void add(const LossTerms& terms, double gradient_norm, LearningStatistics& sum) {
  const auto number = [](const torch::Tensor& term) { return term.item<double>(); };
  sum.action_policy += number(terms.action_policy);
  sum.svo_policy += number(terms.svo_policy);
  sum.value += number(terms.value);
  sum.action_entropy += number(terms.action_entropy);
  sum.svo_entropy += number(terms.svo_entropy);
  sum.valid += number(terms.valid);
  sum.blocking += number(terms.blocking);
  sum.stability += number(terms.stability);
  sum.clipped_share += terms.clipped_share;
  sum.divergence += terms.divergence;
  sum.gradient_norm += gradient_norm;
}

void divide(LearningStatistics& sum, double count) {
  for (double* value : {&sum.action_policy, &sum.svo_policy, &sum.value, &sum.action_entropy,
                        &sum.svo_entropy, &sum.valid, &sum.blocking, &sum.stability,
                        &sum.clipped_share, &sum.divergence, &sum.gradient_norm}) {
    *value /= count;
  }
}

}  // namespace

struct Smp3oLearner::Estimates {
  torch::Tensor social, action;  // advantages
  torch::Tensor returns;
};

void Smp3oLearnerOptions::requireValid() const {
  require(gamma >= 0.0 && gamma <= 1.0, "gamma", gamma, "0 ... 1");
  require(lambda >= 0.0 && lambda <= 1.0, "lambda", lambda, "0 ... 1");
  require(clip > 0.0, "clip", clip, "> 0");
  require(stability_kappa > 0.0, "stability_kappa", stability_kappa, "> 0");
  require(learning_rate > 0.0, "learning_rate", learning_rate, "> 0");
  require(gradient_norm > 0.0, "gradient_norm", gradient_norm, "> 0");
  require(epochs > 0, "epochs", epochs, "> 0");
  require(minibatch_rows > 0, "minibatch_rows", minibatch_rows, "> 0");
  require(sequence_length > 0, "sequence_length", sequence_length, "> 0");
}

Smp3oLearner::Smp3oLearner(PolicyModel model, const Smp3oLearnerOptions& options,
                           torch::Device device)
    : model_(std::move(model)), options_(options), device_(device) {
  options_.requireValid();
  model_->to(device_);
  optimizer_ = std::make_unique<torch::optim::Adam>(
      options_.only_critic ? model_->criticParameters() : model_->parameters(),
      torch::optim::AdamOptions(options_.learning_rate));
}

LearningStatistics Smp3oLearner::update(const Rollout& rollout, sylph::Rng& rng) {
  const Estimates estimates = estimate(rollout);
  std::vector<Sequence> sequences = cutIntoSequences(rollout.pieces, options_.sequence_length);
  LearningStatistics statistics;
  int updates = 0;
  for (int epoch = 0; epoch < options_.epochs; ++epoch) {
    // Whole sequences, since the memory runs through them; rows of one step belong together by
    // their partners.
    sylph::shuffle(sequences, rng);
    std::vector<Sequence> chosen;
    std::int64_t rows = 0;
    for (std::size_t index = 0; index < sequences.size(); ++index) {
      chosen.push_back(sequences[index]);
      rows += sequences[index].rowCount();
      if (rows >= options_.minibatch_rows || index + 1 == sequences.size()) {
        const LossTerms terms = evaluate(rollout, estimates, SequenceLayout(std::move(chosen)));
        add(terms, takeStep(terms.total(options_.weights)), statistics);
        ++updates;
        chosen.clear();
        rows = 0;
      }
    }
  }
  divide(statistics, updates);
  return statistics;
}

Smp3oLearner::Estimates Smp3oLearner::estimate(const Rollout& rollout) const {
  return {advantagesFrom(rollout.social_rewards, rollout, options_),
          advantagesFrom(rollout.action_rewards, rollout, options_),
          advantagesFrom(rollout.external_rewards, rollout, options_) + rollout.values};
}

PolicyOutput Smp3oLearner::decide(const Rollout& rollout, const SequenceLayout& layout,
                                  const torch::Tensor& rows) {
  PolicyInput input;
  const torch::Tensor partners =
      toTensor(layout.world_rows) + rollout.partners.index_select(0, rows);
  std::tie(input.hop1, input.hop2) = hopMatrices(
      {partners.data_ptr<std::int64_t>(), partners.data_ptr<std::int64_t>() + partners.numel()});
  input.hop1 = input.hop1.to(device_);
  input.hop2 = input.hop2.to(device_);
  input.views = rollout.views.index_select(0, rows).to(device_).permute({0, 3, 1, 2});
  input.vectors = rollout.vectors.index_select(0, rows).to(device_);
  input.svo = rollout.svo.index_select(0, rows).to(device_);
  const torch::Tensor features = model_->features(input);

  torch::Tensor memory =
      rollout.memory.index_select(0, rows.narrow(0, 0, layout.step_counts.front())).to(device_);
  std::vector<torch::Tensor> actions;
  std::vector<torch::Tensor> svo;
  std::vector<torch::Tensor> values;
  std::vector<torch::Tensor> blocking;
  std::int64_t first = 0;
  for (const std::int64_t count : layout.step_counts) {
    const PolicyOutput output =
        model_->decide(features.narrow(0, first, count), memory.narrow(0, 0, count));
    actions.push_back(output.actions);
    svo.push_back(output.svo);
    values.push_back(output.values);
    blocking.push_back(output.blocking);
    memory = output.memory;
    first += count;
  }
  PolicyOutput decided;
  decided.actions = torch::cat(actions);
  decided.svo = torch::cat(svo);
  decided.values = torch::cat(values);
  decided.blocking = torch::cat(blocking);
  decided.memory = memory;
  return decided;
}

LossTerms Smp3oLearner::evaluate(const Rollout& rollout, const Estimates& estimates,
                                 const SequenceLayout& layout) {
  const torch::Tensor rows = toTensor(layout.rows);
  const auto take = [&](const torch::Tensor& column) {
    return column.index_select(0, rows).to(device_);
  };
  LossTargets targets;
  targets.actions = take(rollout.actions);
  targets.action_log_probs = take(rollout.action_log_probs);
  targets.svo_levels = take(rollout.svo_levels);
  targets.svo_log_probs = take(rollout.svo_log_probs);
  targets.has_svo_choice = take(rollout.has_svo_choice);
  targets.returns = take(estimates.returns);
  targets.valid = take(rollout.valid);
  targets.blocks = take(rollout.blocks);
  targets.expected_svo = expectedSvo(take(rollout.svo), take(rollout.svo_now),
                                     take(rollout.overlaps), options_.stability_kappa);
  const torch::Tensor all = torch::ones_like(targets.has_svo_choice);
  const bool crossed = options_.crossed_advantages;
  targets.action_advantages = normalized(take(crossed ? estimates.social : estimates.action), all);
  targets.svo_advantages =
      normalized(take(crossed ? estimates.action : estimates.social), targets.has_svo_choice);
  return smp3oLosses(decide(rollout, layout, rows), targets, options_.clip);
}

double Smp3oLearner::takeStep(const torch::Tensor& loss) {
  model_->zero_grad();
  loss.backward();
  const double norm = torch::nn::utils::clip_grad_norm_(optimizer_->param_groups().front().params(),
                                                        options_.gradient_norm);
  optimizer_->step();
  return norm;
}

}  // namespace sylph_training
