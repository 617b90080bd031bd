#include "sylph_core/policy/policy.hpp"

#include <stdexcept>

#include "sylph_core/policy/observation.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

void requireSize(const std::string& entry, int value, int allowed) {
  if (value != allowed) {
    throw std::invalid_argument("metadata '" + entry + "' is '" + std::to_string(value) +
                                "': must be '" + std::to_string(allowed) + "'");
  }
}

Network readNetwork(const TensorFile& weights, const std::string& name) {
  try {
    const NetworkShape shape = NetworkShape::fromMetadata(weights.metadata);
    requireSize("channels", shape.channels, kChannelCount);
    requireSize("vector_size", shape.vector_size, kVectorSize);
    requireSize("svo_levels", shape.svo_levels, kSvoLevelCount);
    return {shape, weights, name};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

bool readMemory(const TensorFile& weights, const std::string& name) {
  const auto entry = weights.metadata.find("memory");
  if (entry == weights.metadata.end() || entry->second == "false") {
    return false;
  }
  if (entry->second != "true") {
    throw std::runtime_error(name + ": metadata 'memory' is '" + entry->second +
                             "': must be 'true' or 'false'");
  }
  return true;
}

}  // namespace

Policy Policy::load(const std::string& path) {
  return {loadTensorFile(path), path};
}

Policy::Policy(const TensorFile& weights, const std::string& name)
    : network_(readNetwork(weights, name)), has_memory_(readMemory(weights, name)) {}

}  // namespace sylph
