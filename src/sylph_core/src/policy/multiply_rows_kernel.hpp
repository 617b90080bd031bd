#pragma once

#include "multiply_rows.hpp"

namespace sylph::policy_kernels {
namespace {

/// @tparam kLanes  floats of a vector register of the instruction set compiled for
/// @tparam kRows   rows at once: with two vectors a row their sums fill the registers
template <int kLanes, int kRows>
struct Kernel {
  static constexpr int kColumns = 2 * kLanes;
  // g++ 12 drops the attribute from an alias that depends on a template parameter.
  // NOLINTNEXTLINE(modernize-use-using)
  typedef float Vector __attribute__((vector_size(kLanes * sizeof(float))));
  static_assert(sizeof(Vector) == kLanes * sizeof(float));

  static Vector load(const float* from) {
    Vector vector;
    __builtin_memcpy(&vector, from, sizeof(vector));
    return vector;
  }

  static void multiplyBlock(const Multiplication& task, const float* const* in, int column,
                            float* sums_out) {
    Vector sums[kRows][2];
    const float* bias = task.bias + column;
    for (auto& row : sums) {
      row[0] = load(bias);
      row[1] = load(bias + kLanes);
    }
    const float* weight = task.weight + column;
    for (int segment = 0; segment < task.segments; ++segment) {
      const int begin = segment * task.segment_stride;
      const int end = begin + task.segment_length;
      for (int k = begin; k < end; ++k, weight += task.padded_outputs) {
        const Vector low = load(weight);
        const Vector high = load(weight + kLanes);
        for (int row = 0; row < kRows; ++row) {
          sums[row][0] += in[row][k] * low;
          sums[row][1] += in[row][k] * high;
        }
      }
    }
    for (int row = 0; row < kRows; ++row) {
      __builtin_memcpy(sums_out + row * kColumns, &sums[row], sizeof(sums[row]));
    }
  }

  static void write(const float* sums, int count, bool relu, float* out) {
    for (int k = 0; k < count; ++k) {
      out[k] = relu && sums[k] < 0.F ? 0.F : sums[k];
    }
  }

  static void multiply(const Multiplication& task) {
    for (int first = 0; first < task.rows; first += kRows) {
      const int taken = task.rows - first < kRows ? task.rows - first : kRows;
      const float* in[kRows];
      for (int row = 0; row < kRows; ++row) {  // the last block repeats its first row
        in[row] = task.inputs[first + (row < taken ? row : 0)];
      }
      for (int column = 0; column < task.outputs_per_row; column += kColumns) {
        float sums[kRows * kColumns];
        multiplyBlock(task, in, column, sums);
        const int left = task.outputs_per_row - column;
        const int useful = left < kColumns ? left : kColumns;
        for (int row = 0; row < taken; ++row) {
          write(sums + row * kColumns, useful, task.relu, task.outputs[first + row] + column);
        }
      }
    }
  }
};

}  // namespace
}  // namespace sylph::policy_kernels
