#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sylph {

/// A dense array of floats, row-major (the last index runs fastest).
struct Tensor {
  std::vector<std::int64_t> shape;  ///< one size for each dimension
  std::vector<float> values;        ///< product of `shape` of them
};

/// Named tensors with notes: what a safetensors file holds.
struct TensorFile {
  std::map<std::string, Tensor> tensors;        ///< by name
  std::map<std::string, std::string> metadata;  ///< safetensors' `__metadata__`
};

/// Reads a safetensors file (https://github.com/huggingface/safetensors, "Format"): 8 bytes of
/// header length, a JSON header, then the data. Only F32 is accepted.
/// @throws std::runtime_error with one line naming the file, the tensor and what is wrong: nothing
/// in the file is trusted, neither lengths nor offsets nor shapes
TensorFile loadTensorFile(const std::string& path);

/// Writes the file beside its place and renames it, so that a reader or a crash never sees a half.
/// @throws std::runtime_error if the file cannot be written
/// @throws std::invalid_argument if a tensor's values do not fill its shape
void saveTensorFile(const TensorFile& file, const std::string& path);

/// "[32, 21, 3, 3]"
std::string toString(const std::vector<std::int64_t>& shape);

}  // namespace sylph
