#include "sylph_training/model/policy_model.hpp"

#include <cmath>
#include <set>
#include <stdexcept>
#include <tuple>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/policy/observation.hpp"

namespace sylph_training {
namespace {

namespace nn = torch::nn;

constexpr std::int64_t kQuarterCells = 9;  // pixels after the last convolution

nn::Conv2d convolution(int in, int out, int stride) {
  nn::Conv2d layer(nn::Conv2dOptions(in, out, 3).padding(1).stride(stride));
  return layer;
}

// (rows, width) -> (rows, heads, width / heads)
torch::Tensor splitHeads(const torch::Tensor& rows, int heads) {
  auto shape = rows.sizes().vec();
  const std::int64_t width = shape.back();
  shape.back() = heads;
  shape.push_back(width / heads);
  return rows.reshape(shape);
}

}  // namespace

PolicyInput PolicyInput::to(torch::Device device) const {
  PolicyInput moved = *this;
  for (torch::Tensor* tensor : {&moved.views, &moved.vectors, &moved.svo, &moved.hop1, &moved.hop2,
                                &moved.memory, &moved.asked}) {
    if (tensor->defined()) {
      *tensor = tensor->to(device);
    }
  }
  return moved;
}

/// Attention layers with what follows them; the attention itself differs from block to block.
class PolicyModelImpl::Block : public nn::Module {
 public:
  explicit Block(int width)
      : query(register_module("query", nn::Linear(width, width))),
        key(register_module("key", nn::Linear(width, width))),
        value(register_module("value", nn::Linear(width, width))),
        out_(register_module("out", nn::Linear(width, width))),
        norm1_(register_module("norm1", nn::LayerNorm(nn::LayerNormOptions({width})))),
        feed_forward1_(register_module("linear1", nn::Linear(width, 2 * width))),
        feed_forward2_(register_module("linear2", nn::Linear(2 * width, width))),
        norm2_(register_module("norm2", nn::LayerNorm(nn::LayerNormOptions({width})))) {}

  torch::Tensor finish(const torch::Tensor& in, const torch::Tensor& attended) {
    // Layer normalisation wants its own precision, also where the rest runs in bfloat16.
    const torch::Tensor mixed = norm1_->forward((in + out_->forward(attended)).to(torch::kFloat));
    const torch::Tensor fed = feed_forward2_->forward(torch::relu(feed_forward1_->forward(mixed)));
    return norm2_->forward((mixed + fed).to(torch::kFloat));
  }

  // Queries (n x q x width) over keys and values made of `known` (n x k x width).
  torch::Tensor attend(const torch::Tensor& asking, const torch::Tensor& known, int heads) {
    const torch::Tensor q = splitHeads(query->forward(asking), heads).transpose(1, 2);
    const torch::Tensor k = splitHeads(key->forward(known), heads).transpose(1, 2);
    const torch::Tensor v = splitHeads(value->forward(known), heads).transpose(1, 2);
    const double scale = 1.0 / std::sqrt(static_cast<double>(q.size(-1)));
    const torch::Tensor weight = torch::softmax(torch::matmul(q, k.transpose(-2, -1)) * scale, -1);
    const torch::Tensor mixed = torch::matmul(weight, v).transpose(1, 2);
    return finish(asking, mixed.reshape(asking.sizes()));
  }

  nn::Linear query, key, value;

 private:
  nn::Linear out_;
  nn::LayerNorm norm1_;
  nn::Linear feed_forward1_, feed_forward2_;
  nn::LayerNorm norm2_;
};

PolicyModelImpl::PolicyModelImpl(const sylph::NetworkShape& shape, Decoder decoder)
    : shape_(shape), decoder_(decoder) {
  shape.requireValid();
  const int view_width = shape.width - shape.goal_width - shape.message_width;
  const auto encoder = register_module("encoder", std::make_shared<nn::Module>());
  conv1_ = encoder->register_module("conv1", convolution(shape.channels, shape.near_width, 1));
  conv2_ = encoder->register_module("conv2", convolution(shape.near_width, shape.near_width, 1));
  conv3_ = encoder->register_module("conv3", convolution(shape.near_width, shape.far_width, 2));
  conv4_ = encoder->register_module("conv4", convolution(shape.far_width, shape.far_width, 2));
  view_out_ =
      encoder->register_module("out", nn::Linear(shape.far_width * kQuarterCells, view_width));
  goal_ = register_module("goal", nn::Linear(shape.vector_size, shape.goal_width));

  const auto communication = register_module("communication", std::make_shared<nn::Module>());
  message_in_ = communication->register_module(
      "in", nn::Linear(shape.svo_levels + shape.vector_size, shape.message_width));
  among_hops_ =
      communication->register_module("among_hops", std::make_shared<Block>(shape.message_width));
  from_self_ =
      communication->register_module("from_self", std::make_shared<Block>(shape.message_width));

  const auto residual = register_module("residual", std::make_shared<nn::Module>());
  residual1_ = residual->register_module("first", nn::Linear(shape.width, shape.width));
  residual2_ = residual->register_module("second", nn::Linear(shape.width, shape.width));

  if (decoder == Decoder::Lstm) {
    lstm_ = register_module("lstm", nn::LSTMCell(shape.width, shape.width));
  } else {
    semantic_ = register_module("semantic", std::make_shared<Block>(shape.width));
    token_weights_ =
        semantic_->register_module("token_weights", nn::Linear(shape.width, shape.semantic_tokens));
    token_basis_ = semantic_->register_module("token_basis", nn::Linear(shape.width, shape.width));
    positions_ = semantic_->register_parameter(
        "positions", 0.1 * torch::randn({shape.semantic_tokens + 1, shape.width}));
  }

  const auto heads = register_module("heads", std::make_shared<nn::Module>());
  action_head_ = heads->register_module("action", nn::Linear(shape.width, sylph::kActionCount));
  svo_head_ = heads->register_module("svo", nn::Linear(shape.width, shape.svo_levels));
  value_head_ = heads->register_module("value", nn::Linear(shape.width, 1));
  blocking_head_ = heads->register_module("blocking", nn::Linear(shape.width, 1));
}

std::int64_t PolicyModelImpl::memoryWidth() const {
  return decoder_ == Decoder::Lstm ? 2 * shape_.width : shape_.width;
}

std::vector<torch::Tensor> PolicyModelImpl::criticParameters() const {
  std::vector<torch::Tensor> parameters = value_head_->parameters();
  for (const torch::Tensor& parameter : blocking_head_->parameters()) {
    parameters.push_back(parameter);
  }
  return parameters;
}

PolicyOutput PolicyModelImpl::forward(const PolicyInput& input) {
  return decide(features(input), input.memory);
}

torch::Tensor PolicyModelImpl::features(const PolicyInput& input) {
  const auto ask = [&](const torch::Tensor& rows) {
    return input.asked.defined() ? rows.index_select(0, input.asked) : rows;
  };
  const torch::Tensor joined =
      torch::cat({encode(input.views), torch::relu(goal_->forward(ask(input.vectors))),
                  ask(communicate(input))},
                 1);
  return torch::relu(joined + residual2_->forward(torch::relu(residual1_->forward(joined))));
}

PolicyOutput PolicyModelImpl::decide(const torch::Tensor& features, const torch::Tensor& memory) {
  PolicyOutput output;
  torch::Tensor decided;
  if (decoder_ == Decoder::Lstm) {
    const std::vector<torch::Tensor> states = memory.chunk(2, 1);
    torch::Tensor cell;
    std::tie(decided, cell) = lstm_->forward(features, std::tuple(states[0], states[1]));
    output.memory = torch::cat({decided, cell}, 1);
  } else {
    decided = remember(features, memory);
    output.memory = decided;
  }
  output.actions = action_head_->forward(decided);
  output.svo = svo_head_->forward(decided);
  output.values = value_head_->forward(decided).squeeze(1);
  output.blocking = blocking_head_->forward(decided).squeeze(1);
  return output;
}

torch::Tensor PolicyModelImpl::encode(const torch::Tensor& views) {
  const auto convolve = [this](const nn::Conv2d& layer, const torch::Tensor& image) {
    return torch::relu(torch::conv2d(image, layer->weight.to(encoder_type_),
                                     layer->bias.to(encoder_type_), layer->options.stride(),
                                     /*padding=*/1));
  };
  torch::Tensor image = convolve(conv1_, views.to(encoder_type_));
  image = convolve(conv2_, image);
  image = convolve(conv3_, image);
  image = convolve(conv4_, image);
  const torch::Tensor flat = torch::nn::functional::linear(
      image.flatten(1), view_out_->weight.to(encoder_type_), view_out_->bias.to(encoder_type_));
  return torch::relu(flat).to(torch::kFloat);
}

torch::Tensor PolicyModelImpl::communicate(const PolicyInput& input) {
  const torch::Tensor own =
      torch::relu(message_in_->forward(torch::cat({input.svo, input.vectors}, 1)))
          .to(torch::kFloat);
  const torch::Tensor hops =
      torch::stack({own, torch::matmul(input.hop1, own), torch::matmul(input.hop2, own)}, 1);
  const torch::Tensor mixed = among_hops_->attend(hops, hops, shape_.message_heads);
  return from_self_->attend(own.unsqueeze(1), mixed, shape_.message_heads).squeeze(1);
}

// As sylph::Network::remember(): the tokens a_l b + p_l are never formed.
torch::Tensor PolicyModelImpl::remember(const torch::Tensor& features,
                                        const torch::Tensor& memory) {
  const int tokens = shape_.semantic_tokens;
  const torch::Tensor scales = token_weights_->forward(features);
  const torch::Tensor basis = token_basis_->forward(features);
  const torch::Tensor own = memory + positions_[tokens];
  const torch::Tensor places = positions_.narrow(0, 0, tokens);
  const auto split = [&](const torch::Tensor& rows) { return splitHeads(rows, shape_.heads); };
  const torch::Tensor query = split(semantic_->query->forward(own));
  const auto withoutBias = [&](const torch::nn::Linear& layer) {
    return split(torch::nn::functional::linear(basis, layer->weight));
  };
  const auto dot = [](const torch::Tensor& a, const torch::Tensor& b) { return (a * b).sum(-1); };
  const torch::Tensor place_keys = split(semantic_->key->forward(places));  // tokens x heads x d
  const torch::Tensor place_values = split(semantic_->value->forward(places));
  const torch::Tensor basis_logit = dot(query, withoutBias(semantic_->key));  // n x heads
  const torch::Tensor logits =
      torch::cat({basis_logit.unsqueeze(2) * scales.unsqueeze(1) +
                      torch::einsum("nhd,lhd->nhl", {query, place_keys}),
                  dot(query, split(semantic_->key->forward(own))).unsqueeze(2)},
                 2);
  const int head_width = shape_.width / shape_.heads;
  const double scale = std::sqrt(static_cast<double>(head_width));
  const torch::Tensor weight = torch::softmax(logits / scale, -1);
  const torch::Tensor token_weight = weight.narrow(2, 0, tokens);
  const torch::Tensor attended =
      weight.narrow(2, tokens, 1) * split(semantic_->value->forward(own)) +
      (token_weight * scales.unsqueeze(1)).sum(-1, true) * withoutBias(semantic_->value) +
      torch::einsum("nhl,lhd->nhd", {token_weight, place_values});
  return semantic_->finish(own, attended.reshape(own.sizes()));
}

sylph::TensorFile exportWeights(const PolicyModel& model) {
  sylph::TensorFile file;
  file.metadata = model->shape().toMetadata();
  for (const auto& parameter : model->named_parameters()) {
    const torch::Tensor values =
        parameter.value().detach().to(torch::kCPU, torch::kFloat).contiguous();
    file.tensors[parameter.key()] = {
        values.sizes().vec(),
        {values.data_ptr<float>(), values.data_ptr<float>() + values.numel()}};
  }
  return file;
}

void importWeights(const sylph::TensorFile& weights, PolicyModel& model) {
  const torch::NoGradGuard no_grad;
  for (auto& parameter : model->named_parameters()) {
    const auto found = weights.tensors.find(parameter.key());
    if (found == weights.tensors.end() || found->second.shape != parameter.value().sizes().vec()) {
      throw std::invalid_argument("tensor '" + parameter.key() +
                                  "' is missing or of the wrong shape: must be " +
                                  sylph::toString(parameter.value().sizes().vec()));
    }
    const auto& tensor = found->second;
    parameter.value().copy_(torch::from_blob(const_cast<float*>(tensor.values.data()),
                                             parameter.value().sizes(), torch::kFloat));
  }
}

std::pair<torch::Tensor, torch::Tensor> hopMatrices(const std::vector<std::int64_t>& partners) {
  const auto count = static_cast<std::int64_t>(partners.size());
  std::vector<std::set<std::int64_t>> neighbors(partners.size());
  for (std::int64_t agent = 0; agent < count; ++agent) {
    const std::int64_t partner = partners[static_cast<std::size_t>(agent)];
    if (partner != agent) {
      neighbors[static_cast<std::size_t>(agent)].insert(partner);
      neighbors[static_cast<std::size_t>(partner)].insert(agent);
    }
  }
  std::vector<std::int64_t> from;
  std::vector<std::int64_t> to;
  for (std::int64_t agent = 0; agent < count; ++agent) {
    for (const std::int64_t neighbor : neighbors[static_cast<std::size_t>(agent)]) {
      from.push_back(agent);
      to.push_back(neighbor);
    }
  }
  const auto edges = static_cast<std::int64_t>(from.size());
  const torch::Tensor indices =
      torch::stack({torch::tensor(from, torch::kLong), torch::tensor(to, torch::kLong)});
  const torch::Tensor adjacency =
      torch::sparse_coo_tensor(indices, torch::ones({edges}), {count, count});
  const auto normalized = [&](const torch::Tensor& matrix) {
    const torch::Tensor power = matrix.coalesce();
    const torch::Tensor degree = torch::matmul(power, torch::ones({count, 1})).squeeze(1);
    const torch::Tensor scale = torch::where(degree > 0, degree.rsqrt(), torch::zeros_like(degree));
    const torch::Tensor at = power.indices();
    const torch::Tensor values =
        power.values() * scale.index_select(0, at[0]) * scale.index_select(0, at[1]);
    return torch::sparse_coo_tensor(at, values, {count, count}).coalesce();
  };
  return {normalized(adjacency), normalized(torch::matmul(adjacency, adjacency))};
}

}  // namespace sylph_training
