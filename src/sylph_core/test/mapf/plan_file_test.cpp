#include "sylph_core/mapf/plan_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "sylph_core/grid/rng.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

TEST(PlanFileTest, WritesOneConfigurationALine) {
  const TemporaryFolder folder;
  savePlan({{{0, 1}, {12, 3}}, {{0, 2}, {11, 3}}}, folder.path("plan.txt"));
  std::ifstream file(folder.path("plan.txt"));
  EXPECT_EQ("0: (0,1) (12,3)\n1: (0,2) (11,3)\n",
            std::string(std::istreambuf_iterator<char>(file), {}));
}

TEST(PlanFileProperty, ThereAndBackIsTheIdentity) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    Plan plan(1 + drawIndex(rng, 20), Configuration(1 + drawIndex(rng, 20)));
    for (Configuration& cells : plan) {
      for (Cell& cell : cells) {
        cell = {static_cast<int>(drawIndex(rng, 9999)) - 10, static_cast<int>(drawIndex(rng, 99))};
      }
    }
    savePlan(plan, folder.path("plan.txt"));
    EXPECT_EQ(plan, loadPlan(folder.path("plan.txt")));
  }
}

TEST(PlanFileTest, NamesTheLineOfWhatIsWrong) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& error, const std::string& content) {
    expectError("/plan.txt" + error, [&] { loadPlan(folder.write("plan.txt", content)); });
  };
  const std::string form = " here, a line is 'step: (row,col) (row,col) ...'";
  expect(": is empty, must start with '0: (row,col) (row,col) ...'", "");
  expect(":1: 'plan': must be a whole number" + form, "plan\n");
  expect(":1: step 1: must be 0", "1: (0,0)\n");
  expect(":2: step 2: must be 1", "0: (0,0)\n2: (0,0)\n");
  expect(":1: ' (0,0)': must be ':'" + form, "0 (0,0)\n");
  expect(":1: '': must be ')'" + form, "0: (0,0) (1,1");
  expect(":1: '99999999999)': must be a whole number" + form, "0: (0,99999999999)\n");
  expect(":1: 'x,0)': must be a whole number" + form, "0: (x,0)\n");
  expect(":1: 'and': must be '('" + form, "0: (0,0) and\n");
  expect(":1: 0 agents: must be 1 or more", "0:\n");
  expect(":2: 1 agents: must be 2, as in the first line", "0: (0,0) (1,1)\n1: (0,0)\n");
  expectError("/none.txt: there is no such file", [&] { loadPlan(folder.path("none.txt")); });
}

}  // namespace
}  // namespace sylph
