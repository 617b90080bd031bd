#include "sylph_core/policy/dense_layer.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "multiply_rows.hpp"

namespace sylph {
namespace {

using policy_kernels::Multiplication;

using Multiply = void (*)(const Multiplication&);

// The fastest kernel that this processor can run.
Multiply multiplyOfThisProcessor() {
#ifdef SYLPH_X86_KERNELS
  if (__builtin_cpu_supports("avx512f")) {
    return policy_kernels::multiplyRowsAvx512;
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    return policy_kernels::multiplyRowsAvx2;
  }
#endif
  return policy_kernels::multiplyRowsPortable;
}

int roundedUp(int value, int step) {
  return (value + step - 1) / step * step;
}

}  // namespace

DenseLayer::DenseLayer(int outputs, int inputs, const std::vector<float>& weight,
                       const std::vector<float>& bias)
    : outputs_(outputs),
      inputs_(inputs),
      padded_outputs_(roundedUp(outputs, policy_kernels::kPadding)) {
  if (outputs <= 0 || inputs <= 0 ||
      weight.size() != static_cast<std::size_t>(outputs) * static_cast<std::size_t>(inputs) ||
      bias.size() != static_cast<std::size_t>(outputs)) {
    throw std::invalid_argument("a layer of " + std::to_string(outputs) + " x " +
                                std::to_string(inputs) + " got " + std::to_string(weight.size()) +
                                " weights and " + std::to_string(bias.size()) + " biases");
  }
  // Transposed and padded: the kernels hold many outputs in registers and run through the inputs,
  // so that the weights of one input lie side by side and fill whole vectors.
  weight_.assign(static_cast<std::size_t>(inputs) * static_cast<std::size_t>(padded_outputs_), 0.F);
  bias_.assign(static_cast<std::size_t>(padded_outputs_), 0.F);
  std::copy(bias.begin(), bias.end(), bias_.begin());
  for (int output = 0; output < outputs; ++output) {
    for (int input = 0; input < inputs; ++input) {
      weight_[static_cast<std::size_t>(input * padded_outputs_ + output)] =
          weight[static_cast<std::size_t>(output * inputs + input)];
    }
  }
}

void DenseLayer::apply(const Rows& rows, Activation activation) const {
  static const Multiply multiply = multiplyOfThisProcessor();
  Multiplication task{};
  task.inputs = rows.inputs.data();
  task.outputs = rows.outputs.data();
  task.rows = static_cast<int>(rows.inputs.size());
  task.segments = rows.segments;
  task.segment_stride = rows.segment_stride;
  task.segment_length = inputs_ / rows.segments;
  task.weight = weight_.data();
  task.bias = bias_.data();
  task.outputs_per_row = outputs_;
  task.padded_outputs = padded_outputs_;
  task.relu = activation == Activation::Relu;
  multiply(task);
}

void DenseLayer::apply(const float* in, int count, float* out, Activation activation) const {
  Rows rows;
  for (int row = 0; row < count; ++row) {
    rows.inputs.push_back(in + row * inputs_);
    rows.outputs.push_back(out + row * outputs_);
  }
  apply(rows, activation);
}

}  // namespace sylph
