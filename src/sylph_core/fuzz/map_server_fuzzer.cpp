// Any bytes as the YAML of a map_server map, whose image is one of two.

#include "fuzz/reader_input.hpp"
#include "sylph_core/grid/map_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  static const std::string kBytes = kFolder.write("a.pgm", "P5 3 2 255\n\xFE \xFE\xFE\xFE\xCD");
  static const std::string kDigits = kFolder.write("b.pgm", "P2 2 2 9\n0 9 4 5\n");
  const std::string path = kFolder.write("input.yaml", sylph::fuzz::toText(data, size));
  sylph::fuzz::expectAnswer([&] { sylph::loadMapFile(path); });
  return 0;
}
