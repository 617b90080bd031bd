#include "sylph_training/run/training_settings.hpp"

#include <limits>

namespace sylph_training {
namespace {

constexpr std::uint32_t kValidationSeedOffset = 1'000'000'007;  // worlds of their own

sylph::NetworkShape readNetwork(const sylph::YamlMap& yaml) {
  sylph::NetworkShape shape;
  const auto read = [&](const std::string& key, int& value) {
    value = static_cast<int>(yaml.integer(key, value, 1, 4096));
  };
  read("near_width", shape.near_width);
  read("far_width", shape.far_width);
  read("goal_width", shape.goal_width);
  read("message_width", shape.message_width);
  read("message_heads", shape.message_heads);
  read("width", shape.width);
  read("heads", shape.heads);
  read("semantic_tokens", shape.semantic_tokens);
  try {
    shape.requireValid();
  } catch (const std::invalid_argument& error) {
    throw yaml.error("width", error.what());
  }
  yaml.refuseUnread();
  return shape;
}

torch::Device readDevice(const sylph::YamlMap& yaml) {
  if (yaml.word("device", {"cpu", "cuda"}, "cpu") == "cpu") {
    return torch::kCPU;
  }
  if (!torch::cuda::is_available()) {
    throw yaml.error("device", "is 'cuda', but libtorch finds no such device; allowed: cpu");
  }
  return torch::kCUDA;
}

}  // namespace

TrainingSettings TrainingSettings::load(const std::string& path) {
  const sylph::YamlMap yaml = sylph::YamlMap::load(path);
  TrainingSettings settings;
  const auto count = [&](const std::string& key, int otherwise) {
    return static_cast<int>(yaml.integer(key, otherwise, 1, 1000000));
  };
  settings.seed = static_cast<std::uint32_t>(
      yaml.integer("seed", settings.seed, 0, std::numeric_limits<std::uint32_t>::max()));
  settings.device = readDevice(yaml);
  settings.threads = count("threads", settings.threads);
  settings.checkpoint_interval_s = yaml.number(
      "checkpoint_interval_s", settings.checkpoint_interval_s, sylph::Range::positive());
  settings.progress_interval_s =
      yaml.number("progress_interval_s", settings.progress_interval_s, sylph::Range::positive());
  settings.shards = count("shards", settings.shards);
  settings.validation_shards = count("validation_shards", settings.validation_shards);
  settings.worlds_per_shard = count("worlds_per_shard", settings.worlds_per_shard);
  if (const auto network = yaml.map("network")) {
    settings.network = readNetwork(*network);
  }
  settings.decoder =
      yaml.word("decoder", {"semantic_transformer", "lstm"}, "semantic_transformer") == "lstm"
          ? Decoder::Lstm
          : Decoder::SemanticTransformer;
  if (const auto worlds = yaml.map("worlds")) {
    settings.worlds = WorldSettings::read(*worlds);
  }
  if (const auto demonstrations = yaml.map("demonstrations")) {
    settings.demonstrations = DemonstrationSettings::read(*demonstrations);
  }
  settings.phases = yaml.maps("phases");
  yaml.refuseUnread();
  return settings;
}

ShardSettings trainingShards(const TrainingSettings& settings, const std::string& run_folder) {
  return {run_folder + "/demonstrations", settings.seed, settings.worlds_per_shard, settings.worlds,
          settings.demonstrations};
}

ShardSettings validationShards(const TrainingSettings& settings, const std::string& run_folder) {
  return {run_folder + "/validation", settings.seed + kValidationSeedOffset,
          settings.worlds_per_shard, settings.worlds, settings.demonstrations};
}

}  // namespace sylph_training
