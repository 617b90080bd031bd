// Any bytes as another solver's plan, in each format.

#include "fuzz/reader_input.hpp"
#include "sylph_core/mapf/solver_plan_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sylph::ScratchFolder kFolder("fuzz");
  const std::string path = kFolder.write("plan.txt", sylph::fuzz::toText(data, size));
  for (const auto format :
       {sylph::PlanFormat::Sylph, sylph::PlanFormat::Lacam, sylph::PlanFormat::Paths}) {
    sylph::fuzz::expectAnswer([&] { sylph::loadSolverPlan(path, format); });
  }
  return 0;
}
