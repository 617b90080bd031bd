#include "sylph_core/experiment/experiment.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sylph_core/mapf/check_plan.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

const char kMap[] = "type octile\nheight 2\nwidth 4\nmap\n..@.\n..@.\n";
const char kExperiment[] = R"(map: a.map
cell_size_m: 0.5
footprint_m: [0.3, 0.2]
seed: 7
robots:
  - {name: robot_0, start: [0, 0], goal: [1, 1]}
  - {name: robot_1, rigid_body: Base 1, footprint_m: [0.4, 0.35], start: [0, 1], goal: [0, 0]}
planning: {planner: pibt, time_limit_s: 2.5, weights: w.safetensors}
execution: {speed_limit_mps: 0.4, command_latency_s: 0}
)";

std::string allPlanners() {
  std::string names;
  for (const std::string& name : plannerNames()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

class ExperimentTest : public ::testing::Test {
 protected:
  ExperimentTest() { folder_.write("a.map", kMap); }

  std::string write(const std::string& content) const { return folder_.write("lab.yaml", content); }

  /// The experiment above with one place changed.
  static std::string changed(const std::string& from, const std::string& to) {
    std::string text = kExperiment;
    const std::size_t position = text.find(from);
    EXPECT_NE(std::string::npos, position) << from;
    return text.replace(position, from.size(), to);
  }

  void expectRefused(const std::string& error, const std::string& from,
                     const std::string& to) const {
    expectError("/lab.yaml" + error, [&] { loadExperiment(write(changed(from, to))); });
  }

  TemporaryFolder folder_;
};

TEST_F(ExperimentTest, ReadsEveryField) {
  const Experiment experiment = loadExperiment(write(kExperiment));
  EXPECT_EQ("lab", experiment.name);
  EXPECT_EQ(folder_.path("lab.yaml"), experiment.path);
  EXPECT_EQ(folder_.path("a.map"), experiment.map_path);
  EXPECT_EQ(Grid::fromText("..#.\n..#.\n"), experiment.grid);
  EXPECT_DOUBLE_EQ(0.5, experiment.cell_size_m);
  EXPECT_EQ(7U, experiment.seed);
  ASSERT_EQ(2U, experiment.robots.size());
  EXPECT_EQ("robot_0", experiment.robots[0].rigid_body);
  EXPECT_DOUBLE_EQ(0.3, experiment.robots[0].length_m);
  EXPECT_DOUBLE_EQ(0.2, experiment.robots[0].width_m);
  EXPECT_EQ("Base 1", experiment.robots[1].rigid_body);
  EXPECT_DOUBLE_EQ(0.35, experiment.robots[1].width_m);
  EXPECT_EQ((Cell{0, 1}), experiment.robots[1].start);
  EXPECT_EQ((Cell{1, 1}), experiment.robots[0].goal);
  EXPECT_EQ("pibt", experiment.planning.planner);
  EXPECT_EQ(folder_.path("w.safetensors"), experiment.planning.weights_path);
  EXPECT_DOUBLE_EQ(2.5, experiment.planning.time_limit_s);
  EXPECT_DOUBLE_EQ(0.4, experiment.execution.speed_limit_mps);
  EXPECT_DOUBLE_EQ(0.0, experiment.execution.command_latency_s);
  EXPECT_DOUBLE_EQ(ExecutionSpec{}.base_timeout_s, experiment.execution.base_timeout_s);
  EXPECT_DOUBLE_EQ(ExecutionSpec{}.pose_timeout_s, experiment.execution.pose_timeout_s);
}

TEST_F(ExperimentTest, OverridesTakeThePlaceOfTheFilesSettings) {
  const std::string path = write(
      "map: a.map\nstarts: random\ngoals: random\nrobots: [{name: a}, {name: b}, {name: c}]\n");
  const auto cellsOf = [&](std::uint32_t seed) {
    return toInstance(loadExperiment(path, {seed, std::nullopt}));
  };
  EXPECT_EQ(cellsOf(3).starts, cellsOf(3).starts);
  EXPECT_EQ(cellsOf(3).goals, cellsOf(3).goals);
  EXPECT_NE(cellsOf(3).starts, cellsOf(4).starts);
  EXPECT_EQ("pibt", loadExperiment(path, {std::nullopt, "pibt"}).planning.planner);
  const Experiment other = loadExperiment(path, {std::nullopt, "sylph", "/w.safetensors"});
  EXPECT_EQ("/w.safetensors", other.planning.weights_path);
  EXPECT_EQ("", loadExperiment(path).planning.weights_path);
  expectError("planner 'astar': must be one of " + allPlanners(), [&] {
    loadExperiment(path, {std::nullopt, "astar"});
  });
}

TEST_F(ExperimentTest, DrawsOnlyWhatIsRandom) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Experiment goals = loadExperiment(
        write("map: a.map\ngoals: random\nrobots: [{name: a, start: [1, 3]}]\n"), {seed, {}});
    EXPECT_EQ((Cell{1, 3}), goals.robots[0].start);
    EXPECT_EQ(3, goals.robots[0].goal.col);  // the component of the start
    const Experiment starts = loadExperiment(
        write("map: a.map\nstarts: random\nrobots: [{name: a, goal: [1, 3]}]\n"), {seed, {}});
    EXPECT_EQ((Cell{1, 3}), starts.robots[0].goal);
    EXPECT_EQ(3, starts.robots[0].start.col);
  }
}

TEST_F(ExperimentTest, NamesTheFieldThatIsWrong) {
  expectRefused(":1: map: is missing", "map: a.map\n", "");
  expectRefused(
      ":2: cell_size: unknown key, must be one of map, cell_size_m, starts, goals, seed, "
      "footprint_m, robots, planning, execution",
      "cell_size_m", "cell_size");
  expectRefused(":2: map: given twice, must be given once", "cell_size_m: 0.5", "map: b.map");
  expectRefused(":2: cell_size_m: is '-0.5', must be a number > 0", "0.5", "-0.5");
  expectRefused(":2: cell_size_m: is 'half', must be a number > 0", "0.5", "half");
  expectRefused(":3: footprint_m: has 1 values, must be a list of 2 numbers", ", 0.2]", "]");
  expectRefused(":3: footprint_m: is '0', must be a number > 0", "0.2]", "0]");
  expectRefused(":4: seed: is '-1', must be a whole number 0 ... 4294967295", "7", "-1");
  expectRefused(":4: seed: is '1.5', must be a whole number 0 ... 4294967295", "7", "1.5");
  expectRefused(":4: seed: is '4294967296', must be a whole number 0 ... 4294967295", "7",
                "4294967296");
  expectRefused(":4: starts: is 'rand', must be one of random, explicit", "seed: 7",
                "starts: rand");
  expectRefused(":8: planning.planner: is 'astar', must be one of " + allPlanners(), "pibt",
                "astar");
  expectRefused(":8: planning.time_limit_s: is '0', must be a number > 0", "2.5", "0");
  expectRefused(":8: planning: is '5', must be a mapping",
                "{planner: pibt, time_limit_s: 2.5, weights: w.safetensors}", "5");
  expectRefused(":9: execution.speed_limit_mps: is '.inf', must be a number > 0", "mps: 0.4",
                "mps: .inf");
  expectRefused(":9: execution.command_latency_s: is '-1', must be a number >= 0", "s: 0}",
                "s: -1}");
}

TEST_F(ExperimentTest, NamesTheRobotThatIsWrong) {
  expectRefused(":6: robots[0].name: is missing", "name: robot_0, ", "");
  expectRefused(
      ":6: robots[0].name: '0 robot', must be a letter followed by letters, digits and "
      "underscores",
      "robot_0", "0 robot");
  expectRefused(":7: robots[1].name: 'robot_0' is another robot's name too", "robot_1", "robot_0");
  expectRefused(":7: robots[1].rigid_body: 'robot_0' is another robot's rigid body too", "Base 1",
                "robot_0");
  expectRefused(
      ":7: robots[1].colour: unknown key, must be one of name, rigid_body, footprint_m, "
      "start, goal",
      "rigid_body", "colour");
  expectRefused(":6: robots[0].start: is missing", "start: [0, 0], ", "");
  expectRefused(":6: robots[0].start: is a list, must be [row, col]", "[0, 0]", "[0, 0, 0]");
  expectRefused(":6: robots[0].start: is '0.5', must be a whole number -2147483647 ... 2147483647",
                "[0, 0]", "[0, 0.5]");
  expectRefused(":7: robots[0].goal: has no place here, 'goals: random' draws it", "seed",
                "goals: random\nseed");
}

TEST_F(ExperimentTest, RefusesStartsAndGoalsThatNoPlannerCanServe) {
  expectRefused(":6: robots: start (0,4) of agent 0 lies outside the map of 2 x 4 cells", "[0, 0]",
                "[0, 4]");
  expectRefused(":6: robots: start (0,2) of agent 0 lies on an obstacle", "[0, 0]", "[0, 2]");
  expectRefused(":6: robots: start (0,1) of agent 1 is also the start of agent 0", "[0, 0]",
                "[0, 1]");
  expectRefused(":6: robots: goal (1,3) of agent 0 cannot be reached from its start (0,0)",
                "[1, 1]", "[1, 3]");
  expectError("/lab.yaml:4: robots: 7 agents on a map of 6 free cells", [&] {
    loadExperiment(
        write("map: a.map\nstarts: random\ngoals: random\nrobots: [{name: a}, {name: b}, "
              "{name: c}, {name: d}, {name: e}, {name: f}, {name: g}]\n"));
  });
}

TEST_F(ExperimentTest, RefusesFilesThatAreNotExperiments) {
  expectError("/none.yaml: there is no such file",
              [&] { loadExperiment(folder_.path("none.yaml")); });
  expectError("/lab.yaml: is empty, must be a YAML mapping", [&] { loadExperiment(write("")); });
  expectError("/lab.yaml:2: is not YAML: end of map flow not found",
              [&] { loadExperiment(write("map: a.map\nrobots: [{name: a")); });
  expectError("/lab.yaml: is larger than 1048576 bytes",
              [&] { loadExperiment(write(std::string(2'000'000, '#'))); });
  expectError("/b.map: there is no such file",
              [&] { loadExperiment(write(changed("a.map", "b.map"))); });
  expectError("/lab.yaml:5: robots: is empty, must be a list of mappings",
              [&] { loadExperiment(write("map: a.map\nseed: 0\n\n\nrobots: []\n")); });
}

TEST_F(ExperimentTest, AMapServerMapBringsItsCellSize) {
  folder_.write("m.pgm", "P5 2 1 255\n\xFF\xFF");
  const auto mapWith = [&](const std::string& origin) {
    folder_.write("m.yaml", "image: m.pgm\nresolution: 0.25\norigin: " + origin +
                                "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
  };
  const std::string robots = "map: m.yaml\nrobots: [{name: a, start: [0, 0], goal: [0, 1]}]\n";
  mapWith("[0, 0, 0]");
  EXPECT_DOUBLE_EQ(0.25, loadExperiment(write(robots)).cell_size_m);
  EXPECT_DOUBLE_EQ(0.25, loadExperiment(write(robots + "cell_size_m: 0.25\n")).cell_size_m);
  expectError(
      "/lab.yaml:3: cell_size_m: is finer than the map's resolution of 0.25 m, must be at "
      "least that",
      [&] { loadExperiment(write(robots + "cell_size_m: 0.2\n")); });
  expectError(
      "/lab.yaml:3: cell_size_m: a map of 0.250000 x 0.500000 m: smaller than one cell of "
      "0.300000 m",
      [&] { loadExperiment(write(robots + "cell_size_m: 0.3\n")); });
  EXPECT_DOUBLE_EQ(0.0, loadExperiment(write(robots)).corner.x);
  mapWith("[-10.5, 3, 0]");
  const Experiment elsewhere = loadExperiment(write(robots));
  EXPECT_DOUBLE_EQ(-10.375, cellFrameOf(elsewhere).toPoint({0, 0}).x);
  EXPECT_DOUBLE_EQ(3.125, cellFrameOf(elsewhere).toPoint({0, 0}).y);
  EXPECT_EQ(elsewhere.grid, loadMapFor(elsewhere, folder_.path("m.yaml")));
  mapWith("[-10.5, 2, 0]");
  expectError("/m.yaml: origin: must be [-10.5, 3, 0] as of the experiment's map",
              [&] { loadMapFor(elsewhere, folder_.path("m.yaml")); });
  mapWith("[0, 0, 0.1]");
  expectError(
      "/m.yaml: origin: has a yaw of 0.1 rad, must be 0: cells lie along the axes of the "
      "map, turn the image",
      [&] { loadExperiment(write(robots)); });
}

TEST_F(ExperimentTest, AMapOfSlamGetsTheExperimentsCells) {
  std::string image = "P5 19 13 255\n" + std::string(std::size_t{19} * 13, '\xFE');
  image[image.size() - 1 - 18] = '\x00';       // lower left pixel
  image[image.size() - 12 * 19 - 1] = '\x00';  // upper right of those: in the part left over
  folder_.write("slam.pgm", image);
  folder_.write("slam.yaml",
                "image: slam.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::string lab =
      "map: slam.yaml\ncell_size_m: 0.3\nrobots: [{name: a, start: [0, 0], goal: [1, 2]}]\n";
  const Experiment experiment = loadExperiment(write(lab));
  EXPECT_DOUBLE_EQ(0.3, experiment.cell_size_m);
  EXPECT_EQ(Grid::fromText("...\n#..\n"), experiment.grid);
  EXPECT_EQ(experiment.grid, loadMapFor(experiment, folder_.path("slam.yaml")));
  // A footprint that reaches beyond its cell: what lies beside it must be known to be free, too.
  const Experiment wide =
      loadExperiment(write("map: slam.yaml\ncell_size_m: 0.2\nfootprint_m: [0.23, 0.23]\n"
                           "robots: [{name: a, start: [1, 2], goal: [1, 3]}]\n"));
  EXPECT_EQ(Grid::fromText("#...\n#...\n####\n"), wide.grid);
}

class ShippedExperimentTest : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedExperimentTest, IsALabOfEightRobotsForEverySeed) {
  const std::string path = std::string(MAPS_DIR) + "/" + GetParam();
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Experiment experiment = loadExperiment(path, {seed, std::nullopt});
    EXPECT_EQ(8U, experiment.robots.size());
    EXPECT_DOUBLE_EQ(0.3, experiment.cell_size_m);
    EXPECT_DOUBLE_EQ(0.23, experiment.robots[0].length_m);
    EXPECT_DOUBLE_EQ(0.20, experiment.robots[0].width_m);
  }
}

TEST_P(ShippedExperimentTest, HasAPlanWithoutRotationsForEverySeed) {
  const std::string path = std::string(MAPS_DIR) + "/" + GetParam();
  PlanningLimits limits;
  limits.time_limit_s = 20.0;  // a few milliseconds are enough
  limits.first_solution_only = true;
  const PlanningSpec spec = loadExperiment(path).planning;
  EXPECT_EQ("sylph_lacam", spec.planner);
  const auto planner = makePlanner(spec.planner, loadPolicyFor(spec.planner, spec.weights_path));
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Instance instance = toInstance(loadExperiment(path, {seed, std::nullopt}));
    EXPECT_FALSE(instance.motion.rotations);
    Rng rng(seed);
    const PlanningResult result = planner->plan(instance, limits, rng);
    EXPECT_EQ(Outcome::Solved, result.outcome);
    EXPECT_FALSE(checkPlan(instance, result.plan).has_value());
    EXPECT_EQ(result.plan.size() - 1, result.social.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, ShippedExperimentTest,
                         ::testing::Values("lab_random.yaml", "lab_room.yaml", "lab_maze.yaml"));

}  // namespace
}  // namespace sylph
