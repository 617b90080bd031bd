// Any bytes as a file of weights.

#include "fuzz/reader_input.hpp"
#include "sylph_core/policy/tensor_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  const std::string path = kFolder.write("input.safetensors", sylph::fuzz::toText(data, size));
  sylph::fuzz::expectAnswer([&] { sylph::loadTensorFile(path); });
  return 0;
}
