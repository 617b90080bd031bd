#include "sylph_training/run/trainer.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "sylph_core/files/write_file.hpp"
#include "sylph_core/policy/tensor_file.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_training/model/learner.hpp"
#include "sylph_training/run/threads.hpp"

namespace sylph_training {
namespace {

constexpr char kCheckpoint[] = "checkpoint.pt";
constexpr char kWeights[] = "weights.safetensors";

std::int64_t readInteger(torch::serialize::InputArchive& archive, const std::string& key) {
  c10::IValue value;
  archive.read(key, value);
  return value.toInt();
}

// Not by Module::save(): an archive's names are those of a language in which "in", the name of a
// layer, means something else.
void readWeights(torch::serialize::InputArchive& archive, const std::string& key,
                 PolicyModel& model) {
  c10::IValue value;
  archive.read(key, value);
  const std::vector<torch::Tensor> weights = value.toTensorVector();
  auto parameters = model->parameters();
  if (weights.size() != parameters.size()) {
    throw std::runtime_error("the checkpoint is of another network than the configuration's");
  }
  const torch::NoGradGuard no_grad;
  for (std::size_t index = 0; index < weights.size(); ++index) {
    parameters[index].copy_(weights[index]);
  }
}

std::string toText(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string toClock(double seconds) {
  std::array<char, 32> text{};
  const long whole = std::lround(seconds);
  std::snprintf(text.data(), text.size(), "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60,
                whole % 60);
  return text.data();
}

}  // namespace

/// A CSV file: the step, then a phase's figures.
class Trainer::Log {
 public:
  /// @param step  the first to come: lines from there on, of a run that was killed, are dropped
  Log(std::string path, long step) : path_(std::move(path)) {
    std::ifstream old(path_);
    std::string kept;
    std::string line;
    while (std::getline(old, line)) {
      if (kept.empty() || std::strtol(line.c_str(), nullptr, 10) <= step) {
        kept += line + "\n";
      }
    }
    old.close();
    sylph::writeFile(path_, step == 0 ? "" : kept);
    is_empty_ = step == 0 || kept.empty();
  }

  void add(long step, const Figures& figures) {
    std::ostringstream names;
    std::ostringstream values;
    names << "step";
    values << step;
    for (const auto& [name, value] : figures) {
      names << "," << name;
      values << "," << toText(value);
    }
    const std::string headings = is_empty_ ? names.str() + "\n" : "";
    sylph::writeFile(path_, headings + values.str() + "\n", std::ios::app);
    is_empty_ = false;
  }

 private:
  std::string path_;
  bool is_empty_ = true;
};

Trainer::Trainer(TrainingSettings settings, std::string folder, bool resume,
                 const std::string& weights_path)
    : state_{std::move(settings), std::move(folder), nullptr, nullptr}, is_resumed_(resume) {
  useThreads(state_.settings.threads);
  torch::manual_seed(state_.settings.seed);
  state_.model = PolicyModel(state_.settings.network, state_.settings.decoder);
  state_.average = PolicyModel(state_.settings.network, state_.settings.decoder);
  if (!weights_path.empty()) {
    importWeights(sylph::loadTensorFile(weights_path), state_.model);
  }
  copyWeights(state_.model, state_.average);
  state_.model->to(state_.settings.device);
  state_.average->to(state_.settings.device);
  std::filesystem::create_directories(state_.folder);
  const bool is_there = std::filesystem::exists(path(kCheckpoint));
  if (is_there && !resume) {
    throw std::runtime_error(path(kCheckpoint) +
                             ": is there: --resume goes on from it, another --run starts anew");
  }
  if (resume && !is_there) {
    throw std::runtime_error(path(kCheckpoint) + ": is not there, so nothing can be resumed");
  }
}

bool Trainer::run(const std::atomic<bool>& stop) {
  if (is_resumed_) {
    torch::serialize::InputArchive archive;
    archive.load_from(path(kCheckpoint), state_.settings.device);
    first_phase_ = static_cast<std::size_t>(readInteger(archive, "phase_index"));
    first_step_ = readInteger(archive, "step");
    readWeights(archive, "model", state_.model);
    readWeights(archive, "average", state_.average);
  }
  for (std::size_t phase = first_phase_; phase < state_.settings.phases.size(); ++phase) {
    if (!runPhase(phase, stop)) {
      return false;
    }
    first_step_ = 0;
    is_resumed_ = false;
  }
  return true;
}

bool Trainer::runPhase(std::size_t phase_index, const std::atomic<bool>& stop) {
  const sylph::YamlMap& yaml = state_.settings.phases[phase_index];
  const std::string kind = yaml.text("kind");
  const auto phase = makePhase(yaml, state_);
  phase->prepare();
  if (is_resumed_) {
    torch::serialize::InputArchive archive;
    torch::serialize::InputArchive part;
    archive.load_from(path(kCheckpoint), state_.settings.device);
    archive.read("phase", part);
    phase->load(part);
  }
  Log log(path("log_" + std::to_string(phase_index) + "_" + kind + ".csv"), first_step_);
  const sylph::Deadline clock(0.0);
  double checkpoint_s = 0.0;
  double progress_s = 0.0;
  for (long step = first_step_; step < phase->steps(); ++step) {
    const std::optional<Figures> figures = phase->step(step);
    if (!figures) {
      continue;
    }
    const long done = step + 1;
    const bool is_last = done == phase->steps();
    log.add(done, *figures);
    const double elapsed_s = clock.elapsed();
    if (elapsed_s - progress_s >= state_.settings.progress_interval_s || is_last) {
      progress_s = elapsed_s;
      const double rate = static_cast<double>(done - first_step_) / elapsed_s;
      const auto [unit, per_step] = phase->workPerStep();
      std::cout << kind << " " << done << " / " << phase->steps() << ", " << toText(rate * per_step)
                << " " << unit << " a second, "
                << toClock(static_cast<double>(phase->steps() - done) / rate) << " left:";
      for (const auto& [name, value] : *figures) {
        std::cout << " " << name << " " << toText(value);
      }
      std::cout << std::endl;
    }
    if (elapsed_s - checkpoint_s >= state_.settings.checkpoint_interval_s || is_last || stop) {
      checkpoint_s = elapsed_s;
      saveCheckpoint(phase_index, done, *phase);
    }
    if (stop) {
      return false;
    }
  }
  return true;
}

void Trainer::saveCheckpoint(std::size_t phase_index, long step, const Phase& phase) {
  torch::serialize::OutputArchive archive;
  archive.write("phase_index", c10::IValue(static_cast<std::int64_t>(phase_index)));
  archive.write("step", c10::IValue(static_cast<std::int64_t>(step)));
  archive.write("model", c10::IValue(state_.model->parameters()));
  archive.write("average", c10::IValue(state_.average->parameters()));
  torch::serialize::OutputArchive part(archive.compilation_unit());
  phase.save(part);
  archive.write("phase", part);
  const std::string partial = path(kCheckpoint) + ".partial";
  archive.save_to(partial);
  std::filesystem::rename(partial, path(kCheckpoint));

  sylph::TensorFile weights = exportWeights(state_.average);
  weights.metadata["phase"] = state_.settings.phases[phase_index].text("kind");
  weights.metadata["step"] = std::to_string(step);
  weights.metadata["seed"] = std::to_string(state_.settings.seed);
  for (const auto& [key, value] : phase.notes()) {
    weights.metadata[key] = value;
  }
  sylph::saveTensorFile(weights, path(kWeights));
}

}  // namespace sylph_training
