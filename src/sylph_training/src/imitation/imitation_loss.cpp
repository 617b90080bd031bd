#include "sylph_training/imitation/imitation_phase.hpp"

namespace sylph_training {
namespace {

namespace F = torch::nn::functional;

constexpr double kOutOfQuestion = 1e9;  // below the logits of actions that are compared

/// Log probabilities in which each of the actions that are alike has that of all of them together.
torch::Tensor withAlikeAsOne(const torch::Tensor& log_probabilities,
                             const torch::Tensor& is_alike) {
  const torch::Tensor together =
      torch::logsumexp(log_probabilities - kOutOfQuestion * (1.0 - is_alike), 1, true);
  return torch::where(is_alike > 0.5, together, log_probabilities);
}

/// 1 for samples whose label tells something, a.
torch::Tensor isTold(const torch::Tensor& targets) {
  return (targets.sum(1) > 0.0).to(torch::kFloat);
}

/// Mean over the rows of which `mask` is 1; 0 if there are none.
torch::Tensor meanWhere(const torch::Tensor& mask, const torch::Tensor& rows) {
  return (mask * rows).sum() / mask.sum().clamp_min(1.0);
}

}  // namespace

ImitationLoss imitationLoss(PolicyModel& model, const ImitationBatch& batch,
                            const ImitationSettings& settings) {
  const PolicyOutput output = model->forward(batch.input);
  const torch::Tensor compared = output.actions - kOutOfQuestion * (1.0 - batch.is_compared);
  const torch::Tensor log_probabilities = torch::log_softmax(compared, 1);
  const torch::Tensor is_told = isTold(batch.targets);
  const torch::Tensor cross_entropy = meanWhere(
      is_told, -(batch.targets * withAlikeAsOne(log_probabilities, batch.is_alike)).sum(1));
  const torch::Tensor svo = -(batch.svo_targets * torch::log_softmax(output.svo, 1)).sum(1).mean();
  ImitationLoss loss;
  loss.total = cross_entropy + settings.svo_weight * svo;
  if (settings.valid_weight > 0.0) {
    loss.total = loss.total + settings.valid_weight * F::binary_cross_entropy_with_logits(
                                                          output.actions, batch.is_valid);
  }
  const torch::Tensor likeliest = compared.detach().argmax(1);
  const torch::Tensor is_best = batch.is_best.gather(1, likeliest.unsqueeze(1)).squeeze(1);
  loss.told = is_told.sum().item<double>();
  loss.cross_entropy = cross_entropy.item<double>();
  loss.accuracy = meanWhere(is_told, (likeliest == batch.actions).to(torch::kFloat)).item<double>();
  loss.best = meanWhere(is_told, is_best).item<double>();
  loss.samples = static_cast<double>(batch.sampleCount());
  loss.svo = svo.item<double>();
  return loss;
}

}  // namespace sylph_training
