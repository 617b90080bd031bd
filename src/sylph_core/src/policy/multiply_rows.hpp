#pragma once

namespace sylph::policy_kernels {

/// y = W x + b for many rows x, see DenseLayer.
struct Multiplication {
  const float* const* inputs;  // per row, its first segment
  float* const* outputs;       // per row
  int rows;
  int segments;
  int segment_stride;   // floats
  int segment_length;   // floats
  const float* weight;  // inputs x padded_outputs
  const float* bias;    // padded_outputs
  int outputs_per_row;
  int padded_outputs;  // a multiple of kPadding
  bool relu;
};

constexpr int kPadding = 32;

// One function for each instruction set. The same source is compiled with other flags, so it holds
// nothing but plain loops: an inline function of the standard library would be shared with code for
// older processors.
void multiplyRowsPortable(const Multiplication& task);
#ifdef SYLPH_X86_KERNELS
void multiplyRowsAvx2(const Multiplication& task);
void multiplyRowsAvx512(const Multiplication& task);
#endif

}  // namespace sylph::policy_kernels
