#pragma once

#include <string>

#include "sylph_core/files/yaml_map.hpp"
#include "sylph_training/model/policy_model.hpp"

namespace sylph_training {

/// In what the encoder of views computes; the rest is always in float.
enum class Precision {
  Auto,  ///< bfloat16 if a short measurement finds it faster here: without instructions of its own
         ///< a processor is ten times slower in it
  Float,
  Bfloat16,
};

/// Of the field `precision`.
/// @throws std::runtime_error with one line naming file, line, field and what is allowed
Precision readPrecision(const sylph::YamlMap& yaml);

/// Samples a second that a model learns from, forward and backward, with its encoder in one type.
/// Takes about a tenth of a second to a few seconds. The model's weights stay as they are.
double measureLearningRate(PolicyModel& model, torch::ScalarType type, torch::Device device);

/// The type that is meant, where need be after a measurement.
torch::ScalarType encoderType(Precision precision, PolicyModel& model, torch::Device device);

/// As it stands in the metadata of weights.
std::string nameOf(torch::ScalarType type);

}  // namespace sylph_training
