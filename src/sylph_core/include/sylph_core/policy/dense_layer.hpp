#pragma once

#include <vector>

namespace sylph {

/// A matrix of weights, packed for multiplyRows().
///
/// y = W x + b for many x. The columns of W may be cut into equal segments that lie apart in
/// memory, so that a convolution needs no copy of its patches: a 3 x 3 patch of an image that
/// stores the channels of a pixel side by side is three segments of three pixels.
class DenseLayer {
 public:
  DenseLayer() = default;

  /// @param weight  outputs x inputs, row-major
  /// @param bias    outputs
  /// @throws std::invalid_argument if the sizes disagree
  DenseLayer(int outputs, int inputs, const std::vector<float>& weight,
             const std::vector<float>& bias);

  int inputs() const { return inputs_; }
  int outputs() const { return outputs_; }

  /// What follows the affine map.
  enum class Activation { None, Relu };

  /// Where inputs and outputs of a number of rows lie. All pointers are to floats that outlive the
  /// call.
  struct Rows {
    std::vector<const float*> inputs;  ///< first segment of each row
    std::vector<float*> outputs;       ///< outputs() floats each
    int segments = 1;                  ///< inputs() is a multiple of it
    int segment_stride = 0;            ///< floats from one segment to the next
  };
  void apply(const Rows& rows, Activation activation) const;

  /// Rows side by side: `count` times inputs() floats to `count` times outputs() floats.
  void apply(const float* in, int count, float* out, Activation activation) const;

 private:
  int outputs_ = 0;
  int inputs_ = 0;
  int padded_outputs_ = 0;
  std::vector<float> weight_;  // inputs x padded outputs: one input's weights side by side
  std::vector<float> bias_;    // padded
};

}  // namespace sylph
