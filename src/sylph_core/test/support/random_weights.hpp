#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/policy/network.hpp"
#include "sylph_core/policy/policy.hpp"
#include "sylph_core/policy/tensor_file.hpp"

namespace sylph {

/// Weights that nobody has trained, with the metadata of the shape.
class RandomWeights {
 public:
  /// @param scale  1: about as large as weights before training
  RandomWeights(const NetworkShape& shape, std::uint32_t seed, double scale = 1.0)
      : rng_(seed), scale_(scale) {
    file_.metadata = shape.toMetadata();
    convolution("encoder.conv1", shape.near_width, shape.channels);
    convolution("encoder.conv2", shape.near_width, shape.near_width);
    convolution("encoder.conv3", shape.far_width, shape.near_width);
    convolution("encoder.conv4", shape.far_width, shape.far_width);
    const int width = shape.width;
    dense("encoder.out", width - shape.goal_width - shape.message_width, shape.far_width * 9);
    dense("goal", shape.goal_width, shape.vector_size);
    dense("communication.in", shape.message_width, shape.svo_levels + shape.vector_size);
    attention("communication.among_hops", shape.message_width);
    attention("communication.from_self", shape.message_width);
    dense("residual.first", width, width);
    dense("residual.second", width, width);
    dense("semantic.token_weights", shape.semantic_tokens, width);
    dense("semantic.token_basis", width, width);
    add("semantic.positions", {shape.semantic_tokens + 1, width}, 1.0);
    attention("semantic", width);
    dense("heads.action", kActionCount, width);
    dense("heads.svo", shape.svo_levels, width);
    dense("heads.value", 1, width);
    dense("heads.blocking", 1, width);
  }

  TensorFile& file() { return file_; }

 private:
  void add(const std::string& name, const std::vector<std::int64_t>& shape, double bound) {
    std::size_t size = 1;
    for (const std::int64_t side : shape) {
      size *= static_cast<std::size_t>(side);
    }
    Tensor& tensor = file_.tensors[name];
    tensor.shape = shape;
    for (std::size_t index = 0; index < size; ++index) {
      tensor.values.push_back(
          static_cast<float>(scale_ * bound * (2.0 * drawFraction(rng_) - 1.0)));
    }
  }
  void layer(const std::string& name, const std::vector<std::int64_t>& shape, int inputs) {
    const double bound = 1.0 / std::sqrt(inputs);
    add(name + ".weight", shape, bound);
    add(name + ".bias", {shape.front()}, bound);
  }
  void dense(const std::string& name, int outputs, int inputs) {
    layer(name, {outputs, inputs}, inputs);
  }
  void convolution(const std::string& name, int outputs, int channels) {
    layer(name, {outputs, channels, 3, 3}, channels * 9);
  }
  void attention(const std::string& name, int width) {
    for (const std::string part : {"query", "key", "value", "out"}) {
      dense(name + "." + part, width, width);
    }
    dense(name + ".linear1", 2 * width, width);
    dense(name + ".linear2", width, 2 * width);
    for (const std::string norm : {"norm1", "norm2"}) {
      add(name + "." + norm + ".weight", {width}, 1.0);
      add(name + "." + norm + ".bias", {width}, 1.0);
    }
  }

  TensorFile file_;
  Rng rng_;
  double scale_;
};

/// A network small enough for tests.
inline NetworkShape smallShape() {
  NetworkShape shape;
  shape.near_width = 6;
  shape.far_width = 8;
  shape.goal_width = 4;
  shape.message_width = 8;
  shape.width = 24;
  shape.semantic_tokens = 4;
  return shape;
}

/// Weights of a policy and of a network that ranks moves by cost.
inline TensorFile withCostNetwork(TensorFile policy, const TensorFile& cost) {
  for (const auto& [name, tensor] : cost.tensors) {
    policy.tensors["cost." + name] = tensor;
  }
  return policy;
}

/// A policy of that size, made once.
inline std::shared_ptr<const Policy> randomPolicy() {
  static const auto policy =
      std::make_shared<const Policy>(RandomWeights(smallShape(), 1).file(), "random weights");
  return policy;
}

}  // namespace sylph
