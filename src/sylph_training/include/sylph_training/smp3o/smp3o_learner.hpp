#pragma once

#include <torch/torch.h>

#include <memory>

#include "sylph_core/grid/rng.hpp"
#include "sylph_training/model/policy_model.hpp"
#include "sylph_training/smp3o/rollout.hpp"
#include "sylph_training/smp3o/sequences.hpp"
#include "sylph_training/smp3o/smp3o_losses.hpp"

namespace sylph_training {

/// How SMP3O learns. Defaults are those of the paper: He et al. 2024 (arXiv:2408.03063), table
/// "Hyperparameters".
struct Smp3oLearnerOptions {
  double gamma = 0.95;             ///< discount, 0 ... 1
  double lambda = 0.95;            ///< of the advantage estimates, 0 ... 1
  double clip = 0.2;               ///< of the probability ratios, > 0
  LossWeights weights;             ///< of the parts of the loss
  double stability_kappa = 5.0;    ///< overlap from which on an agent keeps its SVO, > 0
  bool crossed_advantages = true;  ///< each policy learns from the other's reward
  /// Teach the value and blocking heads alone: those of a network that has learned by imitation
  /// know nothing yet, and what they say would lead its policies astray.
  bool only_critic = false;
  double learning_rate = 1e-5;  ///< of Adam, > 0
  double gradient_norm = 10.0;  ///< to which gradients are clipped, > 0
  int epochs = 10;              ///< over each rollout, > 0
  int minibatch_rows = 2048;    ///< agent steps to an update, about, > 0
  int sequence_length = 1;      ///< steps that gradients go back through the memory, > 0

  /// @throws std::invalid_argument naming the member and what is allowed
  void requireValid() const;
};

/// Means over the updates of one rollout.
struct LearningStatistics {
  /// Losses of the two policies (clipped surrogate) and of the value.
  double action_policy = 0.0, svo_policy = 0.0, value = 0.0;
  /// Entropies of the two policies.
  double action_entropy = 0.0, svo_entropy = 0.0;
  /// Further losses, see LossWeights.
  double valid = 0.0, blocking = 0.0, stability = 0.0;
  /// Share of clipped ratios, KL divergence from the policy of the rollout, norm before clipping.
  double clipped_share = 0.0, divergence = 0.0, gradient_norm = 0.0;
};

/// Social-aware multi-policy PPO. He et al. 2024 (arXiv:2408.03063), "Policy optimization".
///
/// Two policies, of actions and of SVOs, one value head. Advantages are estimated from the rewards
/// of either against the value, which learns the return of the external reward (the paper is
/// silent; so does the authors' code), and crossed over.
class Smp3oLearner {
 public:
  /// @throws std::invalid_argument if the options are not valid
  Smp3oLearner(PolicyModel model, const Smp3oLearnerOptions& options, torch::Device device);

  /// Some epochs over one rollout.
  LearningStatistics update(const Rollout& rollout, sylph::Rng& rng);

  /// What learns.
  PolicyModel& model() { return model_; }
  /// For checkpoints.
  torch::optim::Adam& optimizer() { return *optimizer_; }
  const torch::optim::Adam& optimizer() const { return *optimizer_; }

 private:
  struct Estimates;

  Estimates estimate(const Rollout& rollout) const;
  LossTerms evaluate(const Rollout& rollout, const Estimates& estimates,
                     const SequenceLayout& layout);
  PolicyOutput decide(const Rollout& rollout, const SequenceLayout& layout,
                      const torch::Tensor& rows);
  double takeStep(const torch::Tensor& loss);

  PolicyModel model_;
  Smp3oLearnerOptions options_;
  torch::Device device_;
  std::unique_ptr<torch::optim::Adam> optimizer_;
};

}  // namespace sylph_training
