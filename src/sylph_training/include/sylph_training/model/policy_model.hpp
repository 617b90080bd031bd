#pragma once

#include <torch/torch.h>

#include "sylph_core/policy/network.hpp"
#include "sylph_core/policy/tensor_file.hpp"

namespace sylph_training {

/// Inputs of a number of agents; agents of one joint configuration stand next to each other.
struct PolicyInput {
  torch::Tensor views;    ///< a x channels x 9 x 9: of the agents that are asked for
  torch::Tensor vectors;  ///< n x vector_size: of all agents
  torch::Tensor svo;      ///< n x svo_levels: of all agents
  torch::Tensor hop1;     ///< n x n sparse: the partner graph, symmetrically normalised
  torch::Tensor hop2;     ///< n x n sparse: likewise its square
  torch::Tensor memory;   ///< a x memoryWidth()
  torch::Tensor asked;    ///< a: rows of the agents that are asked for, int64; undefined: all

  /// The same on another device.
  PolicyInput to(torch::Device device) const;
};

/// What the network says of the agents that are asked for.
struct PolicyOutput {
  torch::Tensor actions;   ///< a x 5 logits
  torch::Tensor svo;       ///< a x svo_levels logits
  torch::Tensor values;    ///< a
  torch::Tensor blocking;  ///< a, logits
  torch::Tensor memory;    ///< a x memoryWidth(), to be fed back
};

/// What turns the features of a step and the memory of the one before into decisions.
enum class Decoder {
  SemanticTransformer,  ///< the paper's, and that of sylph::Network
  Lstm,                 ///< what the paper compares it with; for training only
};

/// The network of sylph::Network as something that learns: same names, same shapes, same outputs.
class PolicyModelImpl : public torch::nn::Module {
 public:
  explicit PolicyModelImpl(const sylph::NetworkShape& shape,
                           Decoder decoder = Decoder::SemanticTransformer);

  /// decide() upon features()
  PolicyOutput forward(const PolicyInput& input);
  /// What does not depend on the memory, a x width; many steps at once are cheaper than one by one.
  torch::Tensor features(const PolicyInput& input);
  /// @param memory  a x memoryWidth()
  PolicyOutput decide(const torch::Tensor& features, const torch::Tensor& memory);

  /// Columns of the memory: the width, twice that for an LSTM, which keeps its cell as well.
  std::int64_t memoryWidth() const;
  /// In which type the views are encoded, which is most of the work: torch::kFloat, the default, or
  /// torch::kBFloat16, about twice as fast where the processor knows it. Weights stay in float.
  void setEncoderType(torch::ScalarType type) { encoder_type_ = type; }
  /// Parameters of the value and blocking heads.
  std::vector<torch::Tensor> criticParameters() const;
  /// Sizes of its layers.
  const sylph::NetworkShape& shape() const { return shape_; }

 private:
  class Block;
  torch::Tensor encode(const torch::Tensor& views);
  torch::Tensor communicate(const PolicyInput& input);
  torch::Tensor remember(const torch::Tensor& features, const torch::Tensor& memory);

  sylph::NetworkShape shape_;
  Decoder decoder_;
  torch::ScalarType encoder_type_ = torch::kFloat;
  torch::nn::Conv2d conv1_{nullptr}, conv2_{nullptr}, conv3_{nullptr}, conv4_{nullptr};
  torch::nn::Linear view_out_{nullptr}, goal_{nullptr}, message_in_{nullptr};
  std::shared_ptr<Block> among_hops_, from_self_, semantic_;
  torch::nn::Linear residual1_{nullptr}, residual2_{nullptr};
  torch::nn::Linear token_weights_{nullptr}, token_basis_{nullptr};
  torch::Tensor positions_;
  torch::nn::LSTMCell lstm_{nullptr};
  torch::nn::Linear action_head_{nullptr}, svo_head_{nullptr}, value_head_{nullptr},
      blocking_head_{nullptr};
};
TORCH_MODULE(PolicyModel);

/// The model's weights with the network's shape as metadata, ready for saveTensorFile().
sylph::TensorFile exportWeights(const PolicyModel& model);

/// @throws std::invalid_argument naming the tensor that is missing or of another shape
void importWeights(const sylph::TensorFile& weights, PolicyModel& model);

/// The two normalised hop matrices of agents whose partners are given by row (an agent without
/// partner is its own).
std::pair<torch::Tensor, torch::Tensor> hopMatrices(const std::vector<std::int64_t>& partners);

}  // namespace sylph_training
