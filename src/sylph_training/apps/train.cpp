#include <malloc.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <iostream>

#include "sylph_core/command/run_command.hpp"
#include "sylph_training/run/trainer.hpp"

namespace {

// A signal handler can reach nothing but a global.
std::atomic<bool> stop{false};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

struct Options {
  std::string config;
  std::string folder;
  std::string weights;
  bool resume = false;
};

/// Large tensors come and go with every step. What the allocator gives back to the system in
/// between, the system has to clear page by page when it is asked for again.
void keepFreedMemory() {
  constexpr int kMostKept = 1 << 30;  // [bytes]
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, kMostKept);
}

int train(const Options& options) {
  keepFreedMemory();
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int /*signal*/) { stop = true; });
  }
  sylph_training::Trainer trainer(sylph_training::TrainingSettings::load(options.config),
                                  options.folder, options.resume, options.weights);
  std::cout << (trainer.run(stop) ? "done" : "stopped; --resume goes on from here") << std::endl;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Trains the policy network as a configuration says.", "sylph_train");
  app.add_option("config", options.config, "configuration of the run (YAML)")->required();
  app.add_option("--run", options.folder, "folder of the run: checkpoint, weights, log")
      ->required();
  CLI::Option* weights =
      app.add_option("--weights", options.weights, "begin with these instead of random ones");
  app.add_flag("--resume", options.resume, "go on from the folder's checkpoint")->excludes(weights);
  return sylph::runCommand(app, argc, argv, [&] { return train(options); });
}
