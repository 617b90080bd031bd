#include <CLI/CLI.hpp>
#include <iostream>

#include "sylph_core/command/run_command.hpp"
#include "sylph_training/run/training_settings.hpp"

namespace {

struct Options {
  std::string config;
  std::string folder;
  int first = 0;
  int step = 1;
};

void makeAll(const sylph_training::ShardSettings& settings, int count, const Options& options) {
  const auto source = sylph_training::expertScenes(settings.demonstration);
  for (int shard = options.first; shard < count; shard += options.step) {
    if (sylph_training::makeShard(settings, shard, source)) {
      std::cout << sylph_training::shardPath(settings.folder, shard) << " of " << count
                << std::endl;
    }
  }
}

int demonstrate(const Options& options) {
  const auto settings = sylph_training::TrainingSettings::load(options.config);
  makeAll(sylph_training::validationShards(settings, options.folder), settings.validation_shards,
          options);
  makeAll(sylph_training::trainingShards(settings, options.folder), settings.shards, options);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Makes the demonstrations of a training run; those that are there stay.",
               "sylph_demonstrate");
  app.add_option("config", options.config, "configuration of the run (YAML)")->required();
  app.add_option("--run", options.folder, "folder of the run")->required();
  app.add_option("--first", options.first, "first shard to make")->check(CLI::NonNegativeNumber);
  app.add_option("--step", options.step, "make every so many shards, for several processes")
      ->check(CLI::PositiveNumber);
  return sylph::runCommand(app, argc, argv, [&] { return demonstrate(options); });
}
