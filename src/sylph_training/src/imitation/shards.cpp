#include "sylph_training/imitation/shards.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <random>
#include <utility>

namespace sylph_training {

SceneSource expertScenes(const DemonstrationSettings& settings) {
  return [settings](const sylph::Instance& instance, sylph::Rng& rng, SceneStore& store) {
    const sylph::SearchProblem problem(instance);
    auto plan = findExpertPlan(problem, settings, rng);
    if (!plan) {
      return false;
    }
    Demonstration demonstration;
    demonstration.steps = static_cast<int>(plan->size());
    demonstration.plan = std::move(*plan);
    demonstration.first_moves.assign(instance.starts.size(), sylph::Action::Stay);
    addScenes(instance, problem, demonstration, settings.samples_per_world, settings, rng, store);
    return true;
  };
}

std::string shardPath(const std::string& folder, int index) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "/shard_%05d.scenes", index);
  return folder + name.data();
}

bool makeShard(const ShardSettings& settings, int index, const SceneSource& source) {
  const std::string path = shardPath(settings.folder, index);
  std::filesystem::create_directories(settings.folder);
  if (std::filesystem::exists(path)) {
    return false;
  }
  std::seed_seq seeds{settings.seed, static_cast<std::uint32_t>(index)};
  sylph::Rng rng(seeds);
  SceneStore store;
  for (int world = 0; world < settings.worlds;) {
    world += source(sampleWorld(settings.world, rng), rng, store) ? 1 : 0;
  }
  store.save(path);
  return true;
}

int countShards(const std::string& folder) {
  int count = 0;
  while (std::filesystem::exists(shardPath(folder, count))) {
    ++count;
  }
  return count;
}

}  // namespace sylph_training
