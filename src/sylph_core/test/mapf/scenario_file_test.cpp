#include "sylph_core/mapf/scenario_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

TEST(ScenarioFileTest, XIsTheColumnAndYTheRow) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("a.scen", "version 1\n0\ta.map\t4\t2\t3\t1\t0\t0\t4\n0 a.map 4 2 1 0 2 1 2.5\n");
  const Instance instance = loadScenario(path, Grid(2, 4), 2, MotionModel{true});
  EXPECT_EQ((Configuration{{1, 3}, {0, 1}}), instance.starts);
  EXPECT_EQ((Configuration{{0, 0}, {1, 2}}), instance.goals);
  EXPECT_TRUE(instance.motion.rotations);
  EXPECT_EQ(1, loadScenario(path, Grid(2, 4), 1).agentCount());
}

TEST(ScenarioFileProperty, ThereAndBackIsTheIdentity) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    const Grid grid = mazeMap({12, 17, 1, 0.1}, rng);
    const Instance instance = randomInstance(grid, 20, {}, rng);
    saveScenario(instance, "maps/a.map", folder.path("a.scen"));
    const Instance read = loadScenario(folder.path("a.scen"), grid, 20);
    EXPECT_EQ(instance.starts, read.starts);
    EXPECT_EQ(instance.goals, read.goals);
  }
}

TEST(ScenarioFileTest, NamesTheLineOfWhatIsWrong) {
  const TemporaryFolder folder;
  const Grid grid = Grid::fromText("..#.\n..#.\n");
  const auto expect = [&](const std::string& error, const std::string& content, int agents = 1) {
    expectError("/a.scen" + error,
                [&] { loadScenario(folder.write("a.scen", content), grid, agents); });
  };
  const std::string good = "version 1\n0 a.map 4 2 0 0 1 1 2\n";
  expect(": is empty, must start with 'version 1'", "");
  expect(":1: 'version 2': must be 'version 1'", "version 2\n");
  expect(": has 1 agents, asked for 2", good, 2);
  expect(": has 1 agents, asked for 0", good, 0);
  expect(": has 0 agents, asked for 1", "version 1\n");
  expect(
      ":2: 4 fields, must be 9: bucket, map, width, height, start x, start y, goal x, goal y, "
      "length",
      "version 1\n0 a.map 4 2\n");
  expect(":2: width '5': must be a whole number 4 ... 4", "version 1\n0 a.map 5 2 0 0 1 1 2\n");
  expect(":2: start x '4': must be a whole number 0 ... 3", "version 1\n0 a.map 4 2 4 0 1 1 2\n");
  expect(":2: goal y '-1': must be a whole number 0 ... 1", "version 1\n0 a.map 4 2 0 0 1 -1 2\n");
  expect(":2: goal y 'a': must be a whole number 0 ... 1", "version 1\n0 a.map 4 2 0 0 1 a 2\n");
  expect(": start (0,2) of agent 0 lies on an obstacle", "version 1\n0 a.map 4 2 2 0 1 1 2\n");
  expect(": start (0,0) of agent 1 is also the start of agent 0", good + "0 a.map 4 2 0 0 1 0 2\n",
         2);
  expect(": goal (1,3) of agent 0 cannot be reached from its start (0,0)",
         "version 1\n0 a.map 4 2 0 0 3 1 2\n");
}

}  // namespace
}  // namespace sylph
