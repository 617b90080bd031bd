#pragma once

#include <vector>

#include "sylph_training/imitation/scene_store.hpp"
#include "sylph_training/imitation/symmetry.hpp"
#include "sylph_training/model/policy_model.hpp"

namespace sylph_training {

/// How the regrets of an expert's sample become the distribution to learn. Where the teacher has
/// voted, it is the share of the votes.
struct LabelSettings {
  double expert_share = 0.5;   ///< weight of the expert's own action, 0 ... 1
  double regret_scale = 0.25;  ///< the rest goes as exp(-regret / scale) [timesteps], > 0
};

/// A scene of a store, seen through one of the symmetries of the square.
struct Pick {
  const SceneStore* store;  ///< must outlive the pick
  std::size_t scene;        ///< index in the store
  int symmetry;             ///< 0 ... Symmetry::kCount - 1
};

/// What the network sees and what it should say, for a samples among n agents.
struct ImitationBatch {
  PolicyInput input;          ///< memory all 0
  torch::Tensor targets;      ///< a x 5: probabilities of the actions, all 0 if nothing is told
  torch::Tensor is_compared;  ///< a x 5: 1 where the targets tell of the action
  torch::Tensor is_alike;     ///< a x 5: 1 for actions between which the targets do not tell
  torch::Tensor actions;      ///< a: the expert's or teacher's, int64
  torch::Tensor is_best;      ///< a x 5: 1 where the regret is 0
  torch::Tensor is_valid;     ///< a x 5: 1 where the action hits nothing
  torch::Tensor svo_targets;  ///< a x levels: what the rule of priorities gives

  /// The same on another device.
  ImitationBatch to(torch::Device device) const;
  /// a
  std::int64_t sampleCount() const { return actions.size(0); }
};

/// Puts scenes together; their partner graphs stay apart.
/// @param width  of the memory, which is 0
ImitationBatch makeBatch(const std::vector<Pick>& picks, int width, const LabelSettings& labels);

}  // namespace sylph_training
