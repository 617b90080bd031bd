#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/policy/network.hpp"
#include "sylph_core/policy/observation.hpp"
#include "sylph_core/text/join.hpp"
#include "text/one_line.hpp"

// Reading the network's weights: which tensors there are, of which shape, and how they are laid out
// in memory.

namespace sylph {
namespace {

constexpr char kArchitecture[] = "sylph-2";
constexpr int kPatch = 9;         // pixels of a 3 x 3 convolution
constexpr int kQuarterCells = 9;  // pixels after the last convolution
constexpr int kMaxWidth = 4096;

/// The number that is all of a text; nothing if the text is anything else.
std::optional<int> wholeNumber(const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::make_optional(number) : std::nullopt;
}

/// What the network sees, a line for each number.
std::vector<std::string> observationLines() {
  std::vector<std::string> lines;
  for (const ObservationEntry& entry : observationEntries()) {
    lines.push_back(entry.toText());
  }
  return lines;
}

/// @throws std::invalid_argument naming the first entry that is another than this build's
void requireSameObservation(const std::string& described) {
  std::istringstream stream(described);
  const std::vector<std::string> wanted = observationLines();
  std::size_t index = 0;
  for (std::string line; std::getline(stream, line); ++index) {
    if (index >= wanted.size() || line != wanted[index]) {
      throw std::invalid_argument(
          "metadata 'observation' has '" + line + "' as entry " + std::to_string(index) +
          ": must be " +
          (index < wanted.size() ? "'" + wanted[index] + "'" : "none, this build sees less"));
    }
  }
  if (index < wanted.size()) {
    throw std::invalid_argument("metadata 'observation' lacks entry " + std::to_string(index) +
                                ", '" + wanted[index] + "'");
  }
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw std::runtime_error(inOneLine(name + ": " + what));
}

/// From (outputs x channels x pixels), as the trainer has it, to (outputs x pixels x channels).
std::vector<float> channelsLast(const std::vector<float>& values, int outputs, int channels,
                                int pixels) {
  std::vector<float> result(values.size());
  for (int output = 0; output < outputs; ++output) {
    for (int channel = 0; channel < channels; ++channel) {
      for (int pixel = 0; pixel < pixels; ++pixel) {
        result[static_cast<std::size_t>((output * pixels + pixel) * channels + channel)] =
            values[static_cast<std::size_t>((output * channels + channel) * pixels + pixel)];
      }
    }
  }
  return result;
}

std::vector<float> zeros(int count) {
  std::vector<float> values(static_cast<std::size_t>(count), 0.F);
  return values;
}

}  // namespace

/// Takes tensors out of a file and remembers which.
class Network::Reader {
 public:
  Reader(const TensorFile& file, const std::string& name) : file_(file), name_(name) {}

  const std::vector<float>& take(const std::string& tensor,
                                 const std::vector<std::int64_t>& shape) {
    const auto found = file_.tensors.find(tensor);
    if (found == file_.tensors.end()) {
      refuse(name_,
             "has no tensor '" + tensor + "'; the network needs it, of shape " + toString(shape));
    }
    if (found->second.shape != shape) {
      refuse(name_, "tensor '" + tensor + "' has the shape " + toString(found->second.shape) +
                        ": must be " + toString(shape));
    }
    taken_.insert(tensor);
    return found->second.values;
  }

  DenseLayer dense(const std::string& layer, int outputs, int inputs) {
    return {outputs, inputs, take(layer + ".weight", {outputs, inputs}),
            take(layer + ".bias", {outputs})};
  }
  DenseLayer convolution(const std::string& layer, int outputs, int channels) {
    const auto& weight = take(layer + ".weight", {outputs, channels, 3, 3});
    return {outputs, channels * kPatch, channelsLast(weight, outputs, channels, kPatch),
            take(layer + ".bias", {outputs})};
  }
  DenseLayer flattened(const std::string& layer, int outputs, int channels, int pixels) {
    const auto& weight = take(layer + ".weight", {outputs, channels * pixels});
    return {outputs, channels * pixels, channelsLast(weight, outputs, channels, pixels),
            take(layer + ".bias", {outputs})};
  }
  Norm norm(const std::string& layer, int width) {
    return {Eigen::Map<const Eigen::RowVectorXf>(take(layer + ".weight", {width}).data(), width),
            Eigen::Map<const Eigen::RowVectorXf>(take(layer + ".bias", {width}).data(), width)};
  }
  Attention attention(const std::string& block, int width) {
    return {dense(block + ".query", width, width),
            dense(block + ".key", width, width),
            dense(block + ".value", width, width),
            dense(block + ".out", width, width),
            norm(block + ".norm1", width),
            dense(block + ".linear1", 2 * width, width),
            dense(block + ".linear2", width, 2 * width),
            norm(block + ".norm2", width)};
  }
  // A tensor that is left over is of another network, whose other tensors may only look alike.
  void requireNothingLeft() const {
    for (const auto& [tensor, values] : file_.tensors) {
      if (taken_.count(tensor) == 0) {
        refuse(name_, "tensor '" + tensor + "' is no part of the network");
      }
    }
  }

 private:
  const TensorFile& file_;
  const std::string& name_;
  std::set<std::string> taken_;
};

void NetworkShape::requireValid() const {
  const auto require = [](const std::string& entry, int value, bool is_good,
                          const std::string& allowed) {
    if (!is_good) {
      throw std::invalid_argument(entry + " = " + std::to_string(value) + ": must be " + allowed);
    }
  };
  const std::string width_range = "1 ... " + std::to_string(kMaxWidth);
  const auto requireWidth = [&](const std::string& entry, int value) {
    require(entry, value, value >= 1 && value <= kMaxWidth, width_range);
  };
  requireWidth("channels", channels);
  requireWidth("vector_size", vector_size);
  requireWidth("svo_levels", svo_levels);
  requireWidth("near_width", near_width);
  requireWidth("far_width", far_width);
  requireWidth("goal_width", goal_width);
  requireWidth("message_width", message_width);
  requireWidth("message_heads", message_heads);
  requireWidth("width", width);
  requireWidth("heads", heads);
  requireWidth("semantic_tokens", semantic_tokens);
  require("message_width", message_width, message_width % message_heads == 0,
          "a multiple of message_heads");
  require("width", width, width % heads == 0, "a multiple of heads");
  require("width", width, width > goal_width + message_width,
          "greater than goal_width + message_width");
}

NetworkShape NetworkShape::fromMetadata(const std::map<std::string, std::string>& metadata) {
  const auto text = [&](const std::string& entry) {
    const auto found = metadata.find(entry);
    if (found == metadata.end()) {
      throw std::invalid_argument("metadata has no entry '" + entry + "'");
    }
    return found->second;
  };
  if (text("architecture") != kArchitecture) {
    throw std::invalid_argument("metadata 'architecture' is '" + text("architecture") +
                                "': must be '" + kArchitecture + "'");
  }
  requireSameObservation(text("observation"));
  NetworkShape shape;
  for (const auto& [entry, member] : members()) {
    const std::string value = text(entry);
    const std::optional<int> number = wholeNumber(value);
    if (!number) {
      throw std::invalid_argument("metadata '" + entry + "' is '" + value +
                                  "': must be a whole number");
    }
    shape.*member = *number;
  }
  shape.requireValid();
  return shape;
}

std::map<std::string, std::string> NetworkShape::toMetadata() const {
  std::map<std::string, std::string> metadata = {{"architecture", kArchitecture},
                                                 {"observation", join(observationLines(), "\n")}};
  for (const auto& [entry, member] : members()) {
    metadata[entry] = std::to_string(this->*member);
  }
  return metadata;
}

const std::vector<std::pair<std::string, int NetworkShape::*>>& NetworkShape::members() {
  static const std::vector<std::pair<std::string, int NetworkShape::*>> all = {
      {"channels", &NetworkShape::channels},
      {"vector_size", &NetworkShape::vector_size},
      {"svo_levels", &NetworkShape::svo_levels},
      {"near_width", &NetworkShape::near_width},
      {"far_width", &NetworkShape::far_width},
      {"goal_width", &NetworkShape::goal_width},
      {"message_width", &NetworkShape::message_width},
      {"message_heads", &NetworkShape::message_heads},
      {"width", &NetworkShape::width},
      {"heads", &NetworkShape::heads},
      {"semantic_tokens", &NetworkShape::semantic_tokens}};
  return all;
}

Network::Network(const NetworkShape& shape, const TensorFile& weights, const std::string& name)
    : shape_(shape) {
  shape.requireValid();
  Reader reader(weights, name);
  const int width = shape.width;
  const int view_width = width - shape.goal_width - shape.message_width;
  conv1_ = reader.convolution("encoder.conv1", shape.near_width, shape.channels);
  conv2_ = reader.convolution("encoder.conv2", shape.near_width, shape.near_width);
  conv3_ = reader.convolution("encoder.conv3", shape.far_width, shape.near_width);
  conv4_ = reader.convolution("encoder.conv4", shape.far_width, shape.far_width);
  view_out_ = reader.flattened("encoder.out", view_width, shape.far_width, kQuarterCells);
  goal_ = reader.dense("goal", shape.goal_width, shape.vector_size);
  message_in_ =
      reader.dense("communication.in", shape.message_width, shape.svo_levels + shape.vector_size);
  among_hops_ = reader.attention("communication.among_hops", shape.message_width);
  from_self_ = reader.attention("communication.from_self", shape.message_width);
  residual1_ = reader.dense("residual.first", width, width);
  residual2_ = reader.dense("residual.second", width, width);

  const int tokens = shape.semantic_tokens;
  token_weights_ = reader.dense("semantic.token_weights", tokens, width);
  token_basis_ = reader.dense("semantic.token_basis", width, width);
  positions_ = Eigen::Map<const AgentRows>(
      reader.take("semantic.positions", {tokens + 1, width}).data(), tokens + 1, width);
  semantic_ = reader.attention("semantic", width);
  // Without bias, which goes with the positions: keys are linear in tokens, see Network.
  basis_key_ = {width, width, reader.take("semantic.key.weight", {width, width}), zeros(width)};
  basis_value_ = {width, width, reader.take("semantic.value.weight", {width, width}), zeros(width)};
  position_keys_.resize(tokens, width);
  semantic_.key.apply(positions_.data(), tokens, position_keys_.data(),
                      DenseLayer::Activation::None);
  position_values_.resize(tokens, width);
  semantic_.value.apply(positions_.data(), tokens, position_values_.data(),
                        DenseLayer::Activation::None);

  action_head_ = reader.dense("heads.action", kActionCount, width);
  svo_head_ = reader.dense("heads.svo", shape.svo_levels, width);
  value_head_ = reader.dense("heads.value", 1, width);
  blocking_head_ = reader.dense("heads.blocking", 1, width);
  reader.requireNothingLeft();
}

long Network::multiplyAdds() const {
  const auto cost = [](const DenseLayer& layer) {
    return static_cast<long>(layer.inputs()) * layer.outputs();
  };
  const auto costOf = [&](const Attention& block, int queries, int keys) {
    return queries * (cost(block.query) + cost(block.out) + cost(block.feed_forward1) +
                      cost(block.feed_forward2)) +
           keys * (cost(block.key) + cost(block.value));
  };
  constexpr int kHalfCells = 25;
  constexpr int kHops = 3;
  const long encoder = kViewCells * (cost(conv1_) + cost(conv2_)) + kHalfCells * cost(conv3_) +
                       kQuarterCells * cost(conv4_) + cost(view_out_) + cost(goal_);
  const long communication = cost(message_in_) + costOf(among_hops_, kHops, kHops) +
                             costOf(from_self_, 1, kHops) +
                             2L * kHops * (kHops + 1) * shape_.message_width;
  const long semantic = cost(token_weights_) + cost(token_basis_) + cost(basis_key_) +
                        cost(basis_value_) + costOf(semantic_, 1, 1) +
                        2L * (shape_.semantic_tokens + 2) * shape_.width;
  return encoder + communication + cost(residual1_) + cost(residual2_) + semantic +
         cost(action_head_) + cost(svo_head_) + cost(value_head_) + cost(blocking_head_);
}

}  // namespace sylph
