#include "sylph_training/smp3o/smp3o_losses.hpp"

namespace sylph_training {
namespace {

torch::Tensor meanOver(const torch::Tensor& values, const torch::Tensor& weights) {
  return (values * weights).sum() / weights.sum().clamp_min(1.0);
}

torch::Tensor entropies(const torch::Tensor& log_probs) {
  return -(log_probs.exp() * log_probs).sum(1);
}

torch::Tensor ofChosen(const torch::Tensor& log_probs, const torch::Tensor& chosen) {
  return log_probs.gather(1, chosen.unsqueeze(1)).squeeze(1);
}

}  // namespace

torch::Tensor LossTerms::total(const LossWeights& weights) const {
  return weights.policy * (action_policy + svo_policy) + weights.value * value -
         weights.entropy * (action_entropy + svo_entropy) + weights.valid * valid +
         weights.blocking * blocking + weights.stability * stability;
}

torch::Tensor clippedPolicyLoss(const torch::Tensor& log_probs, const torch::Tensor& old_log_probs,
                                const torch::Tensor& advantages, const torch::Tensor& weights,
                                double clip) {
  const torch::Tensor ratio = (log_probs - old_log_probs).exp();
  const torch::Tensor clipped = ratio.clamp(1.0 - clip, 1.0 + clip);
  return -meanOver(torch::min(ratio * advantages, clipped * advantages), weights);
}

LossTerms smp3oLosses(const PolicyOutput& output, const LossTargets& targets, double clip) {
  const torch::Tensor action_log_probs = torch::log_softmax(output.actions, 1);
  const torch::Tensor svo_log_probs = torch::log_softmax(output.svo, 1);
  const torch::Tensor all = torch::ones_like(targets.has_svo_choice);
  const torch::Tensor chosen = ofChosen(action_log_probs, targets.actions);

  LossTerms terms;
  terms.action_policy =
      clippedPolicyLoss(chosen, targets.action_log_probs, targets.action_advantages, all, clip);
  terms.svo_policy =
      clippedPolicyLoss(ofChosen(svo_log_probs, targets.svo_levels), targets.svo_log_probs,
                        targets.svo_advantages, targets.has_svo_choice, clip);
  terms.value = torch::mse_loss(output.values, targets.returns);
  terms.action_entropy = entropies(action_log_probs).mean();
  terms.svo_entropy = meanOver(entropies(svo_log_probs), targets.has_svo_choice);
  terms.valid = torch::binary_cross_entropy_with_logits(output.actions, targets.valid);
  terms.blocking = torch::binary_cross_entropy_with_logits(output.blocking, targets.blocks);
  // The policy over levels is a softmax; 1 - p is its own in the paper's formula.
  const torch::Tensor others = torch::log1p(-svo_log_probs.exp().clamp_max(1.0 - 1e-6));
  terms.stability = meanOver(
      -(targets.expected_svo * svo_log_probs + (1.0 - targets.expected_svo) * others).mean(1),
      targets.has_svo_choice);

  const torch::NoGradGuard no_grad;
  const torch::Tensor log_ratio = chosen - targets.action_log_probs;
  terms.clipped_share =
      (log_ratio.exp() - 1.0).abs().gt(clip).to(torch::kFloat).mean().item<double>();
  terms.divergence = (log_ratio.exp() - 1.0 - log_ratio).mean().item<double>();
  return terms;
}

torch::Tensor normalized(const torch::Tensor& values, const torch::Tensor& weights) {
  const torch::Tensor mean = meanOver(values, weights);
  const torch::Tensor variance = meanOver((values - mean).square(), weights);
  return (values - mean) / (variance.sqrt() + 1e-6);
}

torch::Tensor expectedSvo(const torch::Tensor& before, const torch::Tensor& now,
                          const torch::Tensor& overlaps, double kappa) {
  const torch::Tensor alpha = (overlaps.clamp(0.0, kappa) / kappa).unsqueeze(1);
  return alpha * before + (1.0 - alpha) * now;
}

}  // namespace sylph_training
