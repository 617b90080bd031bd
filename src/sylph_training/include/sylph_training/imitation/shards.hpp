#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sylph_training/imitation/demonstration.hpp"
#include "sylph_training/worlds/world_sampler.hpp"

namespace sylph_training {

/// What a folder of demonstrations is made of. Each shard is one file of scenes, made from its own
/// seed, so that several processes can share the work and an interrupted one goes on where it was.
struct ShardSettings {
  std::string folder;                   ///< of its files
  std::uint32_t seed = 0;               ///< of shard 0; each shard has its own
  int worlds = 20;                      ///< of one shard, > 0
  WorldSettings world;                  ///< what its worlds are drawn from
  DemonstrationSettings demonstration;  ///< how the expert shows
};

/// Adds the scenes of one world to a store; false if its expert found no plan.
using SceneSource = std::function<bool(const sylph::Instance&, sylph::Rng&, SceneStore&)>;

/// Scenes along the expert's own plans.
SceneSource expertScenes(const DemonstrationSettings& settings);

/// File of a shard.
std::string shardPath(const std::string& folder, int index);

/// Makes one shard unless its file is there. Makes the folder if need be.
/// @return whether it was made now
/// @throws std::runtime_error naming the file that cannot be written
bool makeShard(const ShardSettings& settings, int index, const SceneSource& source);

/// The shards of a folder that are whole, counted from 0 up to the first that is missing.
int countShards(const std::string& folder);

}  // namespace sylph_training
