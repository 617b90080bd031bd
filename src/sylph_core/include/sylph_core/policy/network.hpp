#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/mapf/types.hpp"
#include "sylph_core/policy/dense_layer.hpp"
#include "sylph_core/policy/tensor_file.hpp"

namespace sylph {

/// Sizes of the policy network. They travel in the metadata of the weights.
struct NetworkShape {
  int channels = 32;       ///< of each cell in view
  int vector_size = 7;     ///< of the vector to the goal
  int svo_levels = 10;     ///< of the SVO distribution
  int near_width = 32;     ///< channels of the first two convolutions
  int far_width = 64;      ///< channels of the last two
  int goal_width = 16;     ///< of the goal's embedding
  int message_width = 32;  ///< of the communication block, a multiple of message_heads
  int message_heads = 2;
  int width = 128;           ///< of the features of an agent, a multiple of heads
  int heads = 4;             ///< of the semantic transformer
  int semantic_tokens = 16;  ///< L

  /// @throws std::invalid_argument naming the entry and what is allowed
  void requireValid() const;

  /// Metadata of a weight file, with the architecture and what the network sees.
  std::map<std::string, std::string> toMetadata() const;
  /// @throws std::invalid_argument naming the entry that is missing or wrong
  static NetworkShape fromMetadata(const std::map<std::string, std::string>& metadata);

 private:
  static const std::vector<std::pair<std::string, int NetworkShape::*>>& members();
};

/// One row per agent.
using AgentRows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct NetworkInput {
  AgentRows views;  ///< n x (81 channels): the view row by row, the channels of a cell side by side
  AgentRows vectors;  ///< n x vector_size
  AgentRows svo;      ///< n x svo_levels: the distribution of the step before, each row of sum 1
  AgentRows memory;   ///< n x width: the memory of the step before, 0 at the start
  std::vector<AgentId> partners;  ///< n; an agent without partner is its own
};

struct NetworkOutput {
  AgentRows actions;   ///< n x 5 logits, in the order of Action
  AgentRows svo;       ///< n x svo_levels logits
  AgentRows values;    ///< n x 1
  AgentRows blocking;  ///< n x 1 logit: whether the agent blocks another one
  AgentRows memory;    ///< n x width, to be fed back
};

/// The policy network of SYLPH. He et al. 2024 (arXiv:2408.03063), "Attention-based Network".
///
/// A convolutional encoder of the view and a layer for the vector to the goal; a communication
/// block over the partner graph (hops 0, 1, 2 of the undirected graph, each symmetrically
/// normalised, self-attention among the three and cross-attention from the own one); a residual
/// block; and the semantic transformer, whose memory token is fed back from the step before. It
/// differs from the paper in layer instead of batch normalisation, so that the result does not
/// depend on stored statistics, and in the communication block's input, which holds the vector to
/// the goal besides the SVO.
///
/// The tokens T_l = a_l b + p_l are never formed: keys and values are linear in them, and of the
/// self-attention only the memory token's row is read, so that an agent costs O(width^2).
class Network {
 public:
  /// @param name  of the file, for errors
  /// @throws std::runtime_error naming the file and the tensor that is missing, superfluous or of
  /// another shape
  Network(const NetworkShape& shape, const TensorFile& weights, const std::string& name);

  const NetworkShape& shape() const { return shape_; }

  /// @param threads  > 0
  /// @throws std::invalid_argument if a size disagrees with the shape
  NetworkOutput forward(const NetworkInput& input, int threads = 1) const;

  /// Multiplications with addition for one agent and step.
  long multiplyAdds() const;

 private:
  struct Norm {
    Eigen::RowVectorXf scale;
    Eigen::RowVectorXf shift;
  };
  struct Attention {
    DenseLayer query, key, value, out;
    Norm norm1;
    DenseLayer feed_forward1, feed_forward2;  // tensors linear1, linear2, as PyTorch names them
    Norm norm2;
  };
  class Reader;

  void encodeViews(const AgentRows& views, int first, int end, AgentRows& features) const;
  AgentRows communicate(const NetworkInput& input) const;
  AgentRows remember(const AgentRows& features, const AgentRows& memory) const;
  AgentRows attendHops(const AgentRows& queries, const AgentRows& keys,
                       const AgentRows& values) const;
  static AgentRows finished(const Attention& block, const AgentRows& in, const AgentRows& attended);
  static AgentRows normalized(const Norm& norm, const AgentRows& in);

  NetworkShape shape_;
  DenseLayer conv1_, conv2_, conv3_, conv4_, view_out_;
  DenseLayer goal_;
  DenseLayer message_in_;
  Attention among_hops_, from_self_;
  DenseLayer residual1_, residual2_;
  DenseLayer token_weights_, token_basis_;
  AgentRows positions_;  // (tokens + 1) x width, the memory token's last
  Attention semantic_;
  AgentRows position_keys_;  // the tokens' positions through key and value, with their bias
  AgentRows position_values_;
  DenseLayer basis_key_, basis_value_;  // key and value without bias
  DenseLayer action_head_, svo_head_, value_head_, blocking_head_;
};

/// Sums over the hops of the partner graph: features of an agent's neighbours at distance `hops`,
/// with the adjacency's power symmetrically normalised, D^-1/2 A^k D^-1/2. Linear in the number of
/// agents.
/// @param partners  per agent; an agent without partner is its own
/// @param hops      0, 1 or 2
AgentRows aggregateHops(const AgentRows& features, const std::vector<AgentId>& partners, int hops);

}  // namespace sylph
