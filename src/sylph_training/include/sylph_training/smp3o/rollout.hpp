#pragma once

#include <cstdint>
#include <vector>

#include "sylph_training/model/policy_model.hpp"
#include "sylph_training/worlds/environment_batch.hpp"

namespace sylph_training {

/// Steps of one world's agents without interruption.
struct EpisodePiece {
  std::int64_t agents = 0;               ///< of the world
  std::vector<std::int64_t> first_rows;  ///< per step: row of the first agent, the others follow
  std::vector<float> end_values;         ///< per agent: value of the state after the last step
};

/// What was seen and done in a number of steps of a batch of worlds. One row is one agent's step;
/// rows of one step and world stand next to each other.
struct Rollout {
  torch::Tensor views;     ///< rows x 9 x 9 x channels in bfloat16, exact but for the gaps of SVO
  torch::Tensor vectors;   ///< rows x vector_size
  torch::Tensor svo;       ///< rows x levels: of the step before
  torch::Tensor svo_now;   ///< rows x levels: as fed back to the next step
  torch::Tensor memory;    ///< rows x memory width: of the step before
  torch::Tensor cells;     ///< rows x 2, int64: row and column on the map
  torch::Tensor partners;  ///< rows, int64: of the partner, within the world
  torch::Tensor overlaps;  ///< rows: with the partner
  torch::Tensor actions;   ///< rows, int64
  torch::Tensor action_log_probs;  ///< rows
  torch::Tensor svo_levels;        ///< rows, int64
  torch::Tensor svo_log_probs;     ///< rows
  torch::Tensor has_svo_choice;    ///< rows
  torch::Tensor values;            ///< rows
  torch::Tensor valid;             ///< rows x 5
  torch::Tensor blocks;            ///< rows
  torch::Tensor external_rewards;  ///< rows
  torch::Tensor social_rewards;    ///< rows
  torch::Tensor action_rewards;    ///< rows
  std::vector<EpisodePiece> pieces;
  std::vector<EpisodeRecord> episodes;  ///< those that ended meanwhile

  /// Agent steps.
  std::int64_t rowCount() const { return actions.size(0); }
};

/// Lets a policy act in a batch of worlds, step by step, and keeps its memory meanwhile.
class RolloutCollector {
 public:
  /// @param memory_fed_back  whether the network gets its memory of the step before, 0 otherwise
  /// @param device           where the model is
  RolloutCollector(EnvironmentBatch batch, bool memory_fed_back, torch::Device device);

  /// @param steps  of every world, > 0; episodes that end on the way are followed by new ones
  /// @throws std::invalid_argument unless steps is > 0
  Rollout collect(PolicyModel& model, int steps);

 private:
  struct Decision;
  class Pieces;
  Decision decide(PolicyModel& model);
  std::vector<sylph::Action> drawActions(const torch::Tensor& probabilities);
  void recordState(const Decision& decision, const std::vector<sylph::Action>& actions,
                   Rollout& part) const;
  static void recordStep(const BatchStep& step, const std::vector<sylph::Action>& actions,
                         Rollout& part);
  void closePieces(PolicyModel& model, const BatchStep& outcome, bool is_last, Pieces& pieces);
  void carryMemory(const std::vector<std::int64_t>& carried_rows);

  EnvironmentBatch batch_;
  bool memory_fed_back_;
  torch::Device device_;
  torch::Tensor memory_;  // of the batch's rows, on the host
};

}  // namespace sylph_training
