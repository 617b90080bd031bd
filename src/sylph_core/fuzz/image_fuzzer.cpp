// Any bytes as the image of a map_server map; the first says how pixels are taken.

#include "fuzz/reader_input.hpp"
#include "sylph_core/grid/map_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  static const std::string kFields =
      "image: image\nresolution: 0.3\norigin: [0, 0, 0]\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\n";
  static const std::string kTrinary = kFolder.write("trinary.yaml", kFields + "negate: 0\n");
  static const std::string kRaw = kFolder.write("raw.yaml", kFields + "negate: 1\nmode: raw\n");
  if (size == 0) {
    return 0;
  }
  kFolder.write("image", sylph::fuzz::toText(data + 1, size - 1));
  sylph::fuzz::expectAnswer([&] { sylph::loadMapFile(data[0] % 2 == 0 ? kTrinary : kRaw); });
  return 0;
}
