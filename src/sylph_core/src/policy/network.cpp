#include "sylph_core/policy/network.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/policy/observation.hpp"

namespace sylph {
namespace {

using Activation = DenseLayer::Activation;

constexpr float kNormEpsilon = 1e-5F;  // as torch.nn.LayerNorm
constexpr int kHops = 3;               // 0, 1 and 2
constexpr int kHalfSide = 5;           // of the view after the first stride
constexpr int kQuarterSide = 3;        // after the second
constexpr int kAgentsAtOnce = 4;       // their images stay in the cache

AgentRows applied(const DenseLayer& layer, const AgentRows& in, Activation activation) {
  AgentRows out(in.rows(), layer.outputs());
  layer.apply(in.data(), static_cast<int>(in.rows()), out.data(), activation);
  return out;
}

/// Images of some agents side by side, each with a border of one pixel of zeros.
class Images {
 public:
  Images(int count, int side, int channels)
      : side_(side),
        channels_(channels),
        values_(static_cast<std::size_t>(count * (side + 2) * (side + 2) * channels), 0.F) {}
  /// Pixel of the padded image, 0 ... side + 1.
  float* padded(int image, int row, int col) {
    return values_.data() + ((image * (side_ + 2) + row) * (side_ + 2) + col) * channels_;
  }
  int side() const { return side_; }
  int rowStride() const { return (side_ + 2) * channels_; }

 private:
  int side_;
  int channels_;
  std::vector<float> values_;
};

/// A 3 x 3 convolution with a border of zeros: every patch is three segments of three pixels.
template <typename Place>
void convolve(const DenseLayer& layer, Images& in, int count, int stride, int out_side,
              const Place& out) {
  DenseLayer::Rows rows;
  rows.segments = 3;
  rows.segment_stride = in.rowStride();
  for (int image = 0; image < count; ++image) {
    for (int row = 0; row < out_side; ++row) {
      for (int col = 0; col < out_side; ++col) {
        rows.inputs.push_back(in.padded(image, row * stride, col * stride));
        rows.outputs.push_back(out(image, row, col));
      }
    }
  }
  layer.apply(rows, Activation::Relu);
}

void requireSize(const AgentRows& rows, Eigen::Index count, int width, const std::string& what) {
  if (rows.rows() != count || rows.cols() != width) {
    throw std::invalid_argument("network input '" + what + "' is " + std::to_string(rows.rows()) +
                                " x " + std::to_string(rows.cols()) + ": must be " +
                                std::to_string(count) + " x " + std::to_string(width));
  }
}

}  // namespace

NetworkOutput Network::forward(const NetworkInput& input, int threads) const {
  const auto count = static_cast<Eigen::Index>(input.partners.size());
  requireSize(input.views, count, kViewCells * shape_.channels, "views");
  requireSize(input.vectors, count, shape_.vector_size, "vectors");
  requireSize(input.svo, count, shape_.svo_levels, "svo");
  requireSize(input.memory, count, shape_.width, "memory");

  const int view_width = view_out_.outputs();
  AgentRows views(count, view_width);
  std::vector<std::thread> helpers;
  // Shared out by agents, who do not touch each other before the communication block.
  const auto share = [&](int part) { return static_cast<int>(count * part / threads); };
  for (int part = 1; part < threads; ++part) {
    helpers.emplace_back(
        [&, part] { encodeViews(input.views, share(part), share(part + 1), views); });
  }
  encodeViews(input.views, 0, share(1), views);
  for (std::thread& helper : helpers) {
    helper.join();
  }

  AgentRows features(count, shape_.width);
  features << views, applied(goal_, input.vectors, Activation::Relu), communicate(input);
  const AgentRows inner = applied(residual1_, features, Activation::Relu);
  features = (features + applied(residual2_, inner, Activation::None)).cwiseMax(0.F);

  NetworkOutput output;
  output.memory = remember(features, input.memory);
  output.actions = applied(action_head_, output.memory, Activation::None);
  output.svo = applied(svo_head_, output.memory, Activation::None);
  output.values = applied(value_head_, output.memory, Activation::None);
  output.blocking = applied(blocking_head_, output.memory, Activation::None);
  return output;
}

// The view of the agents first ... end - 1: four convolutions, the last two with stride 2, and one
// layer.
void Network::encodeViews(const AgentRows& views, int first, int end, AgentRows& features) const {
  Images seen(kAgentsAtOnce, kFieldOfView, shape_.channels);
  Images near1(kAgentsAtOnce, kFieldOfView, shape_.near_width);
  Images near2(kAgentsAtOnce, kFieldOfView, shape_.near_width);
  Images far1(kAgentsAtOnce, kHalfSide, shape_.far_width);
  AgentRows far2(kAgentsAtOnce, kQuarterSide * kQuarterSide * shape_.far_width);
  const auto inside = [](Images& images) {
    return
        [&images](int image, int row, int col) { return images.padded(image, row + 1, col + 1); };
  };
  const auto flat = [&](int image, int row, int col) {
    return far2.row(image).data() + (row * kQuarterSide + col) * shape_.far_width;
  };
  const int row_size = kFieldOfView * shape_.channels;
  for (int start = first; start < end; start += kAgentsAtOnce) {
    const int count = std::min(kAgentsAtOnce, end - start);
    for (int image = 0; image < count; ++image) {
      for (int row = 0; row < kFieldOfView; ++row) {
        std::copy_n(views.row(start + image).data() + row * row_size, row_size,
                    seen.padded(image, row + 1, 1));
      }
    }
    convolve(conv1_, seen, count, 1, kFieldOfView, inside(near1));
    convolve(conv2_, near1, count, 1, kFieldOfView, inside(near2));
    convolve(conv3_, near2, count, 2, kHalfSide, inside(far1));
    convolve(conv4_, far1, count, 2, kQuarterSide, flat);
    view_out_.apply(far2.data(), count, features.row(start).data(), Activation::Relu);
  }
}

AgentRows Network::normalized(const Norm& norm, const AgentRows& in) {
  AgentRows out(in.rows(), in.cols());
  for (Eigen::Index row = 0; row < in.rows(); ++row) {
    const float mean = in.row(row).mean();
    const float variance = (in.row(row).array() - mean).square().mean();
    out.row(row) =
        ((in.row(row).array() - mean) / std::sqrt(variance + kNormEpsilon)) * norm.scale.array() +
        norm.shift.array();
  }
  return out;
}

// What follows the attention proper: output layer, feed-forward layer, residuals, and the norm
// after each.
AgentRows Network::finished(const Attention& block, const AgentRows& in,
                            const AgentRows& attended) {
  const AgentRows mixed =
      normalized(block.norm1, in + applied(block.out, attended, Activation::None));
  const AgentRows wide = applied(block.feed_forward1, mixed, Activation::Relu);
  return normalized(block.norm2, mixed + applied(block.feed_forward2, wide, Activation::None));
}

// For each row of `queries`, attention over the kHops rows of keys and values of its agent.
AgentRows Network::attendHops(const AgentRows& queries, const AgentRows& keys,
                              const AgentRows& values) const {
  const int head_width = shape_.message_width / shape_.message_heads;
  const Eigen::Index queries_per_agent = queries.rows() * kHops / keys.rows();
  AgentRows attended(queries.rows(), queries.cols());
  for (Eigen::Index row = 0; row < queries.rows(); ++row) {
    // Rows of an agent follow each other, three queries or one.
    const Eigen::Index first = row / queries_per_agent * kHops;
    for (int head = 0; head < shape_.message_heads; ++head) {
      const int column = head * head_width;
      Eigen::RowVector3f weight;
      for (int hop = 0; hop < kHops; ++hop) {
        weight(hop) = queries.row(row)
                          .segment(column, head_width)
                          .dot(keys.row(first + hop).segment(column, head_width)) /
                      std::sqrt(static_cast<float>(head_width));
      }
      weight = (weight.array() - weight.maxCoeff()).exp();
      attended.row(row).segment(column, head_width) =
          weight / weight.sum() * values.block(first, column, kHops, head_width);
    }
  }
  return attended;
}

AgentRows Network::communicate(const NetworkInput& input) const {
  const Eigen::Index count = input.svo.rows();
  AgentRows known(count, shape_.svo_levels + shape_.vector_size);
  known << input.svo, input.vectors;
  const AgentRows own = applied(message_in_, known, Activation::Relu);
  AgentRows hops(count * kHops, shape_.message_width);  // agent by agent
  for (int hop = 0; hop < kHops; ++hop) {
    const AgentRows gathered = aggregateHops(own, input.partners, hop);
    for (Eigen::Index agent = 0; agent < count; ++agent) {
      hops.row(agent * kHops + hop) = gathered.row(agent);
    }
  }
  const auto project = [](const DenseLayer& layer, const AgentRows& in) {
    return applied(layer, in, Activation::None);
  };
  hops = finished(among_hops_, hops,
                  attendHops(project(among_hops_.query, hops), project(among_hops_.key, hops),
                             project(among_hops_.value, hops)));
  return finished(from_self_, own,
                  attendHops(project(from_self_.query, own), project(from_self_.key, hops),
                             project(from_self_.value, hops)));
}

// The semantic transformer: the memory token's row of the self-attention among itself and the
// tokens.
AgentRows Network::remember(const AgentRows& features, const AgentRows& memory) const {
  const auto project = [](const DenseLayer& layer, const AgentRows& in) {
    return applied(layer, in, Activation::None);
  };
  const int tokens = shape_.semantic_tokens;
  const int head_width = shape_.width / shape_.heads;
  const AgentRows scales = project(token_weights_, features);  // a_l
  const AgentRows basis = project(token_basis_, features);     // b
  const AgentRows own = memory.rowwise() + positions_.row(tokens);
  const AgentRows query = project(semantic_.query, own);
  const AgentRows own_key = project(semantic_.key, own);
  const AgentRows own_value = project(semantic_.value, own);
  const AgentRows basis_key = project(basis_key_, basis);
  const AgentRows basis_value = project(basis_value_, basis);
  AgentRows attended(features.rows(), shape_.width);
  Eigen::RowVectorXf weight(tokens + 1);
  for (Eigen::Index agent = 0; agent < features.rows(); ++agent) {
    for (int head = 0; head < shape_.heads; ++head) {
      const int column = head * head_width;
      const auto part = [&](const AgentRows& rows) {
        return rows.row(agent).segment(column, head_width);
      };
      weight.head(tokens) =
          scales.row(agent) * part(query).dot(part(basis_key)) +
          part(query) * position_keys_.block(0, column, tokens, head_width).transpose();
      weight(tokens) = part(query).dot(part(own_key));
      weight /= std::sqrt(static_cast<float>(head_width));
      weight = (weight.array() - weight.maxCoeff()).exp();
      weight /= weight.sum();
      attended.row(agent).segment(column, head_width) =
          weight(tokens) * part(own_value) +
          weight.head(tokens).dot(scales.row(agent)) * part(basis_value) +
          weight.head(tokens) * position_values_.block(0, column, tokens, head_width);
    }
  }
  return finished(semantic_, own, attended);
}

AgentRows aggregateHops(const AgentRows& features, const std::vector<AgentId>& partners, int hops) {
  if (hops == 0) {
    return features;
  }
  std::vector<std::pair<Eigen::Index, Eigen::Index>> edges;  // both directions, each once
  for (std::size_t agent = 0; agent < partners.size(); ++agent) {
    const auto self = static_cast<Eigen::Index>(agent);
    const auto partner = static_cast<Eigen::Index>(partners[agent]);
    if (partner != self) {
      edges.emplace_back(self, partner);
      edges.emplace_back(partner, self);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto adjacencyTimes = [&](const AgentRows& in) {
    AgentRows out = AgentRows::Zero(in.rows(), in.cols());
    for (int hop = 0; hop < hops; ++hop) {
      const AgentRows before = hop == 0 ? in : out;
      out.setZero();
      for (const auto& [from, to] : edges) {
        out.row(from) += before.row(to);
      }
    }
    return out;
  };
  // Row sums of A^k by k products with a vector: A^k itself would cost the square of the number of
  // agents.
  const AgentRows degree = adjacencyTimes(AgentRows::Ones(features.rows(), 1));
  const Eigen::VectorXf scale =
      degree.col(0).unaryExpr([](float d) { return d > 0.F ? 1.F / std::sqrt(d) : 0.F; });
  return scale.asDiagonal() * adjacencyTimes(scale.asDiagonal() * features);
}

}  // namespace sylph
