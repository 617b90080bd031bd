#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/files/yaml_map.hpp"
#include "sylph_core/policy/network.hpp"
#include "sylph_training/imitation/shards.hpp"
#include "sylph_training/model/policy_model.hpp"

namespace sylph_training {

/// A training run as its configuration file describes it.
struct TrainingSettings {
  std::uint32_t seed = 0;                ///< of all draws of the run
  torch::Device device = torch::kCPU;    ///< where the network learns
  int threads = 1;                       ///< of libtorch on the processor, > 0
  double checkpoint_interval_s = 120.0;  ///< wall time between checkpoints [s], > 0
  double progress_interval_s = 10.0;     ///< wall time between lines of progress [s], > 0
  sylph::NetworkShape network;           ///< sizes of its layers
  Decoder decoder = Decoder::SemanticTransformer;
  WorldSettings worlds;                  ///< that demonstrations are made in
  DemonstrationSettings demonstrations;  ///< how the expert shows
  int shards = 150;                      ///< of expert demonstrations, > 0
  int validation_shards = 2;             ///< of worlds that training never sees, > 0
  int worlds_per_shard = 20;             ///< > 0
  std::vector<sylph::YamlMap> phases;    ///< each with its kind; read by makePhase()

  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static TrainingSettings load(const std::string& path);
};

/// The demonstrations to learn from, or those to validate with, in a run's folder.
ShardSettings trainingShards(const TrainingSettings& settings, const std::string& run_folder);
/// Likewise of worlds that training never sees.
ShardSettings validationShards(const TrainingSettings& settings, const std::string& run_folder);

}  // namespace sylph_training
