#include "sylph_core/policy/policy.hpp"

#include <stdexcept>
#include <utility>

#include "sylph_core/policy/observation.hpp"
#include "sylph_core/social/svo.hpp"
#include "text/one_line.hpp"

namespace sylph {
namespace {

void requireSize(const std::string& entry, int value, int allowed) {
  if (value != allowed) {
    throw std::invalid_argument("metadata '" + entry + "' is '" + std::to_string(value) +
                                "': must be '" + std::to_string(allowed) + "'");
  }
}

constexpr char kCostNetwork[] = "cost.";  // begins the names of its tensors

/// The weights of the two networks, names without prefix.
std::pair<TensorFile, TensorFile> split(const TensorFile& weights) {
  std::pair<TensorFile, TensorFile> parts{{{}, weights.metadata}, {{}, weights.metadata}};
  for (const auto& [name, tensor] : weights.tensors) {
    const bool is_of_cost = name.rfind(kCostNetwork, 0) == 0;
    if (is_of_cost) {
      parts.second.tensors[name.substr(sizeof(kCostNetwork) - 1)] = tensor;
    } else {
      parts.first.tensors[name] = tensor;
    }
  }
  return parts;
}

Network readNetwork(const TensorFile& weights, const std::string& name) {
  try {
    const NetworkShape shape = NetworkShape::fromMetadata(weights.metadata);
    requireSize("channels", shape.channels, kChannelCount);
    requireSize("vector_size", shape.vector_size, kVectorSize);
    requireSize("svo_levels", shape.svo_levels, kSvoLevelCount);
    return {shape, weights, name};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(inOneLine(name + ": " + error.what()));
  }
}

bool readMemory(const TensorFile& weights, const std::string& name) {
  const auto entry = weights.metadata.find("memory");
  if (entry == weights.metadata.end() || entry->second == "false") {
    return false;
  }
  if (entry->second != "true") {
    throw std::runtime_error(inOneLine(name + ": metadata 'memory' is '" + entry->second +
                                       "': must be 'true' or 'false'"));
  }
  return true;
}

}  // namespace

Policy Policy::load(const std::string& path) {
  return {loadTensorFile(path), path};
}

Policy::Policy(const TensorFile& weights, const std::string& name) : Policy(split(weights), name) {}

Policy::Policy(const std::pair<TensorFile, TensorFile>& parts, const std::string& name)
    : network_(readNetwork(parts.first, name)), has_memory_(readMemory(parts.first, name)) {
  if (!parts.second.tensors.empty()) {
    cost_network_ = readNetwork(parts.second, name + ", cost network");
  }
}

}  // namespace sylph
