#include "sylph_training/model/learner.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace sylph_training {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

LearnerSettings LearnerSettings::read(const sylph::YamlMap& yaml) {
  LearnerSettings settings;
  const auto positive = [&](const std::string& key, double otherwise) {
    return yaml.number(key, otherwise, sylph::Range::positive());
  };
  settings.learning_rate = positive("learning_rate", settings.learning_rate);
  settings.final_learning_rate = positive("final_learning_rate", settings.final_learning_rate);
  settings.warmup_steps =
      static_cast<int>(yaml.integer("warmup_steps", settings.warmup_steps, 0, 1000000));
  settings.weight_decay =
      yaml.number("weight_decay", settings.weight_decay, sylph::Range::atLeast(0.0));
  settings.gradient_norm = positive("gradient_norm", settings.gradient_norm);
  settings.average_decay = yaml.number("average_decay", settings.average_decay, {0.0, 1.0});
  settings.average_every =
      static_cast<int>(yaml.integer("average_every", settings.average_every, 1, 1000000));
  return settings;
}

Learner::Learner(const LearnerSettings& settings, long steps, PolicyModel model,
                 PolicyModel average)
    : settings_(settings),
      steps_(steps),
      model_(std::move(model)),
      average_(std::move(average)),
      optimizer_(
          model_->parameters(),
          torch::optim::AdamWOptions(settings.learning_rate).weight_decay(settings.weight_decay)) {}

double Learner::learningRate(long step) const {
  if (step < settings_.warmup_steps) {
    return settings_.learning_rate * static_cast<double>(step + 1) / settings_.warmup_steps;
  }
  const double share = static_cast<double>(step - settings_.warmup_steps) /
                       static_cast<double>(std::max(1L, steps_ - settings_.warmup_steps));
  return settings_.final_learning_rate + (settings_.learning_rate - settings_.final_learning_rate) *
                                             0.5 * (1.0 + std::cos(kPi * std::min(share, 1.0)));
}

double Learner::step(long step, const torch::Tensor& loss) {
  for (auto& group : optimizer_.param_groups()) {
    static_cast<torch::optim::AdamWOptions&>(group.options()).lr(learningRate(step));
  }
  optimizer_.zero_grad();
  loss.backward();
  const double norm =
      torch::nn::utils::clip_grad_norm_(model_->parameters(), settings_.gradient_norm);
  optimizer_.step();
  if (step % settings_.average_every == 0) {
    const torch::NoGradGuard no_grad;
    // In the first steps the average forgets faster: it starts from weights that know nothing.
    const auto whole_periods = step / settings_.average_every;
    const auto updates = static_cast<double>(whole_periods);
    const double decay = std::min(settings_.average_decay, (1.0 + updates) / (10.0 + updates));
    const auto weights = model_->parameters();
    auto averages = average_->parameters();
    for (std::size_t index = 0; index < weights.size(); ++index) {
      averages[index].lerp_(weights[index], 1.0 - decay);
    }
  }
  return norm;
}

void Learner::save(torch::serialize::OutputArchive& archive) const {
  optimizer_.save(archive);
}

void Learner::load(torch::serialize::InputArchive& archive) {
  optimizer_.load(archive);
}

void copyWeights(const PolicyModel& from, PolicyModel& to) {
  const torch::NoGradGuard no_grad;
  const auto weights = from->parameters();
  auto copies = to->parameters();
  for (std::size_t index = 0; index < weights.size(); ++index) {
    copies[index].copy_(weights[index]);
  }
}

void save(torch::serialize::OutputArchive& archive, const std::string& key, const sylph::Rng& rng) {
  std::ostringstream stream;
  stream << rng;
  archive.write(key, c10::IValue(stream.str()));
}

void load(torch::serialize::InputArchive& archive, const std::string& key, sylph::Rng& rng) {
  c10::IValue value;
  archive.read(key, value);
  std::istringstream(value.toStringRef()) >> rng;
}

}  // namespace sylph_training
