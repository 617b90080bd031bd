// Any bytes as a scenario of three agents.

#include "fuzz/reader_input.hpp"
#include "sylph_core/mapf/scenario_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  static const sylph::Grid kGrid = sylph::Grid::fromText("..#.\n.#..\n....\n");
  const std::string path = kFolder.write("input.scen", sylph::fuzz::toText(data, size));
  sylph::fuzz::expectAnswer([&] { sylph::loadScenario(path, kGrid, 3); });
  return 0;
}
