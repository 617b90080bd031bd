// Any bytes as an experiment, in whose folder there are maps of both kinds.

#include "fuzz/reader_input.hpp"
#include "sylph_core/experiment/experiment.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  static const std::string kMap =
      kFolder.write("a.map", "type octile\nheight 3\nwidth 4\nmap\n..@.\n.@..\n....\n");
  static const std::string kImage = kFolder.write("m.pgm", "P2 4 3 1\n1 1 0 1 1 0 1 1 1 1 1 1\n");
  static const std::string kMapServer =
      kFolder.write("m.yaml",
                    "image: m.pgm\nresolution: 0.1\norigin: [-1, 2, 0]\nnegate: 0\n"
                    "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::string path = kFolder.write("input.yaml", sylph::fuzz::toText(data, size));
  sylph::fuzz::expectAnswer([&] { sylph::loadExperiment(path); });
  return 0;
}
