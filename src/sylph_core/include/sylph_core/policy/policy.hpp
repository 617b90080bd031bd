#pragma once

#include <optional>
#include <string>
#include <utility>

#include "sylph_core/policy/network.hpp"
#include "sylph_core/policy/tensor_file.hpp"

namespace sylph {

/// What training left behind: the network and how it wants to be used.
class Policy {
 public:
  /// Reads a weight file. Its metadata give the network's shape and, as `memory` (true or false;
  /// false where it is left out), whether the network was trained with its memory fed back. Tensors
  /// whose names begin with `cost.` are of a second network of the same shape.
  /// @throws std::runtime_error with one line naming the file and the metadata entry or the tensor
  /// that is wrong: observations have kChannelCount channels and a vector of kVectorSize entries,
  /// SVOs have kSvoLevelCount levels
  static Policy load(const std::string& path);

  /// @param name  of the weights, for errors
  Policy(const TensorFile& weights, const std::string& name);

  /// The network that the weights belong to.
  const Network& network() const { return network_; }
  /// The one that ranks moves by what they cost, for a search; nullptr where weights have none. Its
  /// memory is not fed back.
  const Network* costNetwork() const { return cost_network_ ? &*cost_network_ : nullptr; }
  /// Whether the memory of a timestep is an input of the next one; it is zero otherwise.
  bool hasMemory() const { return has_memory_; }

 private:
  Policy(const std::pair<TensorFile, TensorFile>& parts, const std::string& name);

  Network network_;
  std::optional<Network> cost_network_;
  bool has_memory_;
};

}  // namespace sylph
