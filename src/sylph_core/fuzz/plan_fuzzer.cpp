// Any bytes as a plan; one that is read is read again as it is written.

#include "fuzz/reader_input.hpp"
#include "sylph_core/mapf/plan_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  const std::string path = kFolder.write("plan.txt", sylph::fuzz::toText(data, size));
  sylph::fuzz::expectAnswer([&] {
    const sylph::Plan plan = sylph::loadPlan(path);
    sylph::savePlan(plan, path);
    if (sylph::loadPlan(path) != plan) {
      sylph::fuzz::fail("a plan is another one when it has been written");
    }
  });
  return 0;
}
