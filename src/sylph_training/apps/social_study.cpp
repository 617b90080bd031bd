#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sylph_core/command/run_command.hpp"
#include "sylph_core/files/write_file.hpp"
#include "sylph_core/policy/tensor_file.hpp"
#include "sylph_training/run/threads.hpp"
#include "sylph_training/run/training_settings.hpp"
#include "sylph_training/smp3o/rollout.hpp"
#include "sylph_training/smp3o/smp3o_phase.hpp"

namespace {

using sylph_training::PolicyModel;
using sylph_training::Rollout;
using sylph_training::Smp3oSettings;

struct Options {
  std::string config;
  std::string weights;
  std::string trace;
  int episodes = 200;
  int length = 9;
  std::uint32_t seed = 90000;
};

/// Those of the last phase: it is what the weights are for.
Smp3oSettings settingsOf(const sylph_training::TrainingSettings& training) {
  if (training.phases.back().text("kind") != "smp3o") {
    throw training.phases.back().error("kind", "must be smp3o in the last phase");
  }
  return Smp3oSettings::read(training.phases.back());
}

Rollout run(PolicyModel& model, const Smp3oSettings& settings, double recess_share, int worlds,
            const Options& options) {
  sylph_training::SymmetricWorldSpec spec =
      settings.symmetric.value_or(sylph_training::SymmetricWorldSpec());
  spec.recess_share = recess_share;
  if (worlds == 1) {
    spec.min_length = spec.max_length = options.length;
  }
  const auto source = [spec](sylph::Rng& rng) { return symmetricWorld(spec, rng); };
  sylph_training::RolloutCollector collector(
      sylph_training::EnvironmentBatch(source, settings.environment, settings.svo, worlds,
                                       options.seed),
      settings.memory, torch::kCPU);
  return collector.collect(model, settings.environment.max_steps);
}

void writeTrace(const Rollout& rollout, const std::string& path) {
  std::ofstream file(path);
  file << "step,agent,row,col,svo_deg,reward,partner\n";
  const sylph_training::EpisodePiece& episode = rollout.pieces.front();
  for (std::size_t step = 0; step < episode.first_rows.size(); ++step) {
    for (std::int64_t agent = 0; agent < episode.agents; ++agent) {
      const std::int64_t row = episode.first_rows[step] + agent;
      file << step << "," << agent << "," << rollout.cells[row][0].item<int>() << ","
           << rollout.cells[row][1].item<int>() << ","
           << rollout.svo_levels[row].item<double>() * sylph::kSvoLevelSpacingDeg << ","
           << rollout.external_rewards[row].item<float>() << ","
           << rollout.partners[row].item<int>() << "\n";
    }
  }
  sylph::closeWritten(file, path);
}

int study(const Options& options) {
  const auto training = sylph_training::TrainingSettings::load(options.config);
  const Smp3oSettings settings = settingsOf(training);
  PolicyModel model(training.network, training.decoder);
  importWeights(sylph::loadTensorFile(options.weights), model);
  sylph_training::useThreads(training.threads);
  nlohmann::ordered_json result;
  for (const auto& [kind, recess_share] : {std::pair("recess", 1.0), std::pair("i_shape", 0.0)}) {
    const Rollout rollout = run(model, settings, recess_share, options.episodes, options);
    for (const auto& [name, value] :
         sylph_training::figuresOf(sylph_training::firstEpisodes(rollout.episodes))) {
      result[kind][name] = value;
    }
  }
  if (!options.trace.empty()) {
    writeTrace(run(model, settings, 0.0, 1, options), options.trace);
  }
  std::cout << result.dump() << std::endl;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Lets a policy act in the symmetric case study and prints how it does, as JSON.",
               "sylph_social_study");
  app.add_option("config", options.config, "configuration of its training (YAML)")->required();
  app.add_option("--weights", options.weights, "its weights")->required();
  app.add_option("--episodes", options.episodes, "of either kind of world")
      ->check(CLI::PositiveNumber);
  app.add_option("--trace", options.trace, "file for one episode in an I-shaped world (CSV)");
  app.add_option("--length", options.length, "of that world's corridor [cells]");
  app.add_option("--seed", options.seed, "of the worlds and of what is drawn");
  return sylph::runCommand(app, argc, argv, [&] { return study(options); });
}
