// Any bytes as a MovingAI map.

#include "fuzz/reader_input.hpp"
#include "sylph_core/grid/map_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  const std::string path = kFolder.write("input.map", sylph::fuzz::toText(data, size));
  sylph::fuzz::expectAnswer([&] { sylph::loadMapFile(path); });
  return 0;
}
