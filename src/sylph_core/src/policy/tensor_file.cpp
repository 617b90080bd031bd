#include "sylph_core/policy/tensor_file.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sylph_core/files/write_file.hpp"
#include "sylph_core/text/join.hpp"
#include "text/json_integer.hpp"
#include "text/one_line.hpp"

namespace sylph {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMaxHeaderBytes = 100'000'000;  // as the reference implementation
constexpr char kMetadataKey[] = "__metadata__";

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw std::runtime_error(inOneLine(path + ": " + what));
}

std::uint64_t elementCount(const std::string& path, const std::string& name,
                           const std::vector<std::int64_t>& shape) {
  std::uint64_t count = 1;
  for (const std::int64_t side : shape) {
    constexpr std::uint64_t kMaxCount = std::numeric_limits<std::uint32_t>::max();
    if (side < 0 || static_cast<std::uint64_t>(side) > kMaxCount ||
        count * static_cast<std::uint64_t>(side) > kMaxCount) {
      refuse(path, "tensor '" + name + "' has the shape " + toString(shape) +
                       ": sides must be >= 0 and their product below 2^32");
    }
    count *= static_cast<std::uint64_t>(side);
  }
  return count;
}

Tensor readTensor(const std::string& path, const std::string& name, const json& entry,
                  const std::string& data) {
  const auto type = entry.at("dtype").get<std::string>();
  if (type != "F32") {
    refuse(path, "tensor '" + name + "' is of type " + type + ": must be F32");
  }
  Tensor tensor;
  tensor.shape = integersOf<std::int64_t>(entry.at("shape"));
  const auto offsets = integersOf<std::uint64_t>(entry.at("data_offsets"));
  const std::uint64_t bytes = elementCount(path, name, tensor.shape) * sizeof(float);
  if (offsets.size() != 2 || offsets[0] > offsets[1] || offsets[1] > data.size() ||
      offsets[1] - offsets[0] != bytes) {
    refuse(path, "tensor '" + name + "' of shape " + toString(tensor.shape) + " needs " +
                     std::to_string(bytes) + " bytes inside the " + std::to_string(data.size()) +
                     " bytes of data; its data_offsets say otherwise");
  }
  tensor.values.resize(bytes / sizeof(float));
  // Not by memcpy(), to which an empty tensor's null is forbidden.
  std::copy_n(data.data() + offsets[0], bytes, reinterpret_cast<char*>(tensor.values.data()));
  return tensor;
}

std::string readAll(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    refuse(path, "cannot be opened");
  }
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string toString(const std::vector<std::int64_t>& shape) {
  return "[" + join(shape, ", ", [](std::int64_t side) { return std::to_string(side); }) + "]";
}

TensorFile loadTensorFile(const std::string& path) {
  const std::string bytes = readAll(path);
  std::uint64_t header_size = 0;
  if (bytes.size() < sizeof(header_size)) {
    refuse(path, "has " + std::to_string(bytes.size()) +
                     " bytes: a safetensors file starts with 8 bytes of header length");
  }
  std::memcpy(&header_size, bytes.data(), sizeof(header_size));
  if (header_size > kMaxHeaderBytes || header_size > bytes.size() - sizeof(header_size)) {
    refuse(path, "claims a header of " + std::to_string(header_size) + " bytes but has " +
                     std::to_string(bytes.size()) + " in all");
  }
  const std::string data = bytes.substr(sizeof(header_size) + header_size);
  TensorFile file;
  try {
    const json header = json::parse(bytes.substr(sizeof(header_size), header_size));
    for (const auto& [name, entry] : header.items()) {
      if (name == kMetadataKey) {
        file.metadata = entry.get<std::map<std::string, std::string>>();
      } else {
        file.tensors.emplace(name, readTensor(path, name, entry, data));
      }
    }
  } catch (const json::exception& error) {
    refuse(path, std::string("bad header: ") + error.what());
  } catch (const std::invalid_argument& error) {
    refuse(path, std::string("bad header: ") + error.what());
  }
  return file;
}

void saveTensorFile(const TensorFile& file, const std::string& path) {
  json header = json::object();
  if (!file.metadata.empty()) {
    header[kMetadataKey] = file.metadata;
  }
  std::uint64_t end = 0;
  for (const auto& [name, tensor] : file.tensors) {
    if (elementCount(path, name, tensor.shape) != tensor.values.size()) {
      throw std::invalid_argument("tensor '" + name + "' has " +
                                  std::to_string(tensor.values.size()) + " values but the shape " +
                                  toString(tensor.shape));
    }
    const std::uint64_t begin = end;
    end += tensor.values.size() * sizeof(float);
    header[name] = {{"dtype", "F32"}, {"shape", tensor.shape}, {"data_offsets", {begin, end}}};
  }
  std::string text = header.dump();
  text.resize((text.size() + 7) / 8 * 8, ' ');  // data starts on a multiple of 8 bytes
  const std::uint64_t header_size = text.size();
  // A trainer that is killed while it writes must leave the weights of before.
  const std::string partial = path + ".partial";
  {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(&header_size), sizeof(header_size));
    stream << text;
    for (const auto& [name, tensor] : file.tensors) {
      stream.write(reinterpret_cast<const char*>(tensor.values.data()),
                   static_cast<std::streamsize>(tensor.values.size() * sizeof(float)));
    }
    closeWritten(stream, partial);
  }
  std::error_code error;
  std::filesystem::rename(partial, path, error);
  if (error) {
    refuse(path, "cannot be replaced: " + error.message());
  }
}

}  // namespace sylph
