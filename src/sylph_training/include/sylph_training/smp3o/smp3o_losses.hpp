#pragma once

#include <torch/torch.h>

#include "sylph_training/model/policy_model.hpp"

namespace sylph_training {

/// Coefficients of the loss. He et al. 2024 (arXiv:2408.03063), table "Hyperparameters"; the
/// stability loss has none there, and gets that of the other two supervised ones.
struct LossWeights {
  double policy = 10.0;  ///< of both policies
  double value = 0.08;
  double entropy = 0.01;  ///< of both policies
  double valid = 0.5;
  double blocking = 0.5;
  double stability = 0.5;
};

/// What the learner knows of a minibatch of n agent steps.
struct LossTargets {
  torch::Tensor actions;            ///< n, int64
  torch::Tensor action_log_probs;   ///< n: when they were drawn
  torch::Tensor action_advantages;  ///< n: what the action policy is trained on
  torch::Tensor svo_levels;         ///< n, int64
  torch::Tensor svo_log_probs;      ///< n: when they were drawn
  torch::Tensor svo_advantages;     ///< n: what the SVO policy is trained on
  torch::Tensor has_svo_choice;     ///< n: 0 where the level was not drawn from the policy
  torch::Tensor returns;            ///< n: what the value should have been
  torch::Tensor valid;              ///< n x 5: 1 for valid actions
  torch::Tensor blocks;             ///< n: 1 if the agent blocks another one
  torch::Tensor expected_svo;       ///< n x levels: z_exp of the stability loss
};

/// The terms of the loss, each a mean over the minibatch and without its coefficient.
struct LossTerms {
  torch::Tensor action_policy, svo_policy;    ///< clipped surrogates, to be minimised
  torch::Tensor value;                        ///< squared error
  torch::Tensor action_entropy, svo_entropy;  ///< to be maximised
  torch::Tensor valid, blocking, stability;   ///< binary cross entropies
  double clipped_share = 0.0;                 ///< of the action ratios outside the clip range
  double divergence = 0.0;                    ///< of the action policy from the old one, estimated

  torch::Tensor total(const LossWeights& weights) const;
};

/// The clipped surrogate, negated: -mean(min(ratio A, clip(ratio, 1 - clip, 1 + clip) A)), over the
/// steps with weight 1; 0 if there are none.
torch::Tensor clippedPolicyLoss(const torch::Tensor& log_probs, const torch::Tensor& old_log_probs,
                                const torch::Tensor& advantages, const torch::Tensor& weights,
                                double clip);

/// The losses of SMP3O. He et al. 2024 (arXiv:2408.03063), "Policy optimization". Which advantage
/// belongs to which policy is for the caller to say.
LossTerms smp3oLosses(const PolicyOutput& output, const LossTargets& targets, double clip);

/// Values less their mean over their standard deviation, over the steps with weight 1.
torch::Tensor normalized(const torch::Tensor& values, const torch::Tensor& weights);

/// z_exp = alpha z' + (1 - alpha) z, alpha = min(overlap, kappa) / kappa: who is in the middle of a
/// conflict with its partner keeps its SVO.
/// @param before, now  n x levels: the SVO distribution of the step before, and of this one
/// @param overlaps     n: of the agent's way with its partner's
/// @param kappa        > 0
torch::Tensor expectedSvo(const torch::Tensor& before, const torch::Tensor& now,
                          const torch::Tensor& overlaps, double kappa);

}  // namespace sylph_training
