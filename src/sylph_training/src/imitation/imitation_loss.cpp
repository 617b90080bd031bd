#include "sylph_core/social/svo.hpp"
#include "sylph_training/imitation/imitation_phase.hpp"

namespace sylph_training {
namespace {

namespace F = torch::nn::functional;

// Cross entropy towards the two ends of the SVO levels, over the samples that tell.
torch::Tensor yieldingLoss(const torch::Tensor& svo_logits, const torch::Tensor& yields) {
  const torch::Tensor is_known = (yields >= 0.0).to(torch::kFloat);
  const torch::Tensor level = (yields > 0.5).to(torch::kLong) * sylph::kMostProsocialLevel;
  const torch::Tensor losses =
      F::cross_entropy(svo_logits, level, F::CrossEntropyFuncOptions().reduction(torch::kNone));
  return (losses * is_known).sum() / is_known.sum().clamp_min(1.0);
}

}  // namespace

ImitationLoss imitationLoss(PolicyModel& model, const ImitationBatch& batch,
                            const ImitationSettings& settings) {
  const PolicyOutput output = model->forward(batch.input);
  const torch::Tensor log_probabilities = torch::log_softmax(output.actions, 1);
  const torch::Tensor cross_entropy = -(batch.targets * log_probabilities).sum(1).mean();
  const torch::Tensor yielding = yieldingLoss(output.svo, batch.yields);
  ImitationLoss loss;
  loss.total = cross_entropy + settings.yielding_weight * yielding;
  if (settings.valid_weight > 0.0) {
    loss.total = loss.total + settings.valid_weight * F::binary_cross_entropy_with_logits(
                                                          output.actions, batch.is_valid);
  }
  const torch::Tensor likeliest = output.actions.detach().argmax(1);
  loss.cross_entropy = cross_entropy.item<double>();
  loss.accuracy = (likeliest == batch.actions).to(torch::kFloat).mean().item<double>();
  loss.best = batch.is_best.gather(1, likeliest.unsqueeze(1)).mean().item<double>();
  loss.yielding = yielding.item<double>();
  return loss;
}

}  // namespace sylph_training
