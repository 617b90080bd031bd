#include "sylph_training/model/precision.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "sylph_core/policy/observation.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph_training {
namespace {

constexpr std::int64_t kRows = 256;  // agents in a batch
constexpr int kRepetitions = 5;

PolicyInput blankInput(const PolicyModel& model, torch::Device device) {
  PolicyInput input;
  const torch::Tensor views =
      torch::zeros({kRows, sylph::kFieldOfView, sylph::kFieldOfView, sylph::kChannelCount});
  input.views = views.permute({0, 3, 1, 2});
  input.vectors = torch::zeros({kRows, sylph::kVectorSize});
  input.svo = torch::full({kRows, sylph::kSvoLevelCount}, 1.0 / sylph::kSvoLevelCount);
  input.memory = torch::zeros({kRows, model->memoryWidth()});
  input.asked = torch::arange(kRows, torch::kLong);
  std::vector<std::int64_t> alone;
  for (std::int64_t row = 0; row < kRows; ++row) {
    alone.push_back(row);
  }
  std::tie(input.hop1, input.hop2) = hopMatrices(alone);
  return input.to(device);
}

}  // namespace

Precision readPrecision(const sylph::YamlMap& yaml) {
  const std::string word = yaml.word("precision", {"auto", "float", "bfloat16"}, "auto");
  return word == "auto"    ? Precision::Auto
         : word == "float" ? Precision::Float
                           : Precision::Bfloat16;
}

double measureLearningRate(PolicyModel& model, torch::ScalarType type, torch::Device device) {
  model->setEncoderType(type);
  const PolicyInput input = blankInput(model, device);
  // The quickest counts: what else runs on the machine only ever makes it slower.
  double seconds = std::numeric_limits<double>::infinity();
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    const sylph::Deadline clock(0.0);
    const PolicyOutput output = model->forward(input);
    output.actions.sum().backward();
    seconds = std::min(seconds, clock.elapsed());
  }
  model->zero_grad();
  return static_cast<double>(kRows) / seconds;
}

torch::ScalarType encoderType(Precision precision, PolicyModel& model, torch::Device device) {
  if (precision != Precision::Auto) {
    return precision == Precision::Bfloat16 ? torch::kBFloat16 : torch::kFloat;
  }
  return measureLearningRate(model, torch::kBFloat16, device) >
                 measureLearningRate(model, torch::kFloat, device)
             ? torch::kBFloat16
             : torch::kFloat;
}

std::string nameOf(torch::ScalarType type) {
  return type == torch::kBFloat16 ? "bfloat16" : "float";
}

}  // namespace sylph_training
