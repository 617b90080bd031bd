#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "sylph_core/experiment/experiment.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

const char kExperiment[] = R"(map: a.map
cell_size_m: 0.5
seed: 4000000000
robots:
  - {name: robot_0, footprint_m: [0.3, 0.1], start: [0, 0], goal: [1, 1]}
  - {name: cf1, rigid_body: "Base #1: 'x'", footprint_m: [0.4, 0.35], start: [0, 1], goal: [0, 0]}
planning: {planner: pibt, time_limit_s: 2.5, weights: w.safetensors}
execution: {speed_limit_mps: 0.333333333333, acceleration_limit_mps2: 1e-3, turn_rate_limit_radps: 0.4,
  position_tolerance_m: 0.011, heading_tolerance_rad: 0.05, tracking_error_m: 0.013,
  pose_timeout_s: 0.2, base_timeout_s: 0.3, command_latency_s: 0}
)";

class SaveExperimentTest : public ::testing::Test {
 protected:
  SaveExperimentTest() {
    folder_.write("a.map", "type octile\nheight 2\nwidth 4\nmap\n..@.\n..@.\n");
    folder_.write("lab.yaml", kExperiment);
  }

  static void expectSame(const Experiment& a, const Experiment& b) {
    EXPECT_EQ(a.map_path, b.map_path);
    EXPECT_EQ(a.grid, b.grid);
    EXPECT_EQ(a.cell_size_m, b.cell_size_m);
    EXPECT_EQ(a.seed, b.seed);
    ASSERT_EQ(a.robots.size(), b.robots.size());
    for (std::size_t i = 0; i < a.robots.size(); ++i) {
      EXPECT_EQ(a.robots[i].name, b.robots[i].name);
      EXPECT_EQ(a.robots[i].rigid_body, b.robots[i].rigid_body);
      EXPECT_EQ(a.robots[i].length_m, b.robots[i].length_m);
      EXPECT_EQ(a.robots[i].width_m, b.robots[i].width_m);
      EXPECT_EQ(a.robots[i].start, b.robots[i].start);
      EXPECT_EQ(a.robots[i].goal, b.robots[i].goal);
    }
    EXPECT_EQ(a.planning.planner, b.planning.planner);
    EXPECT_EQ(a.planning.weights_path, b.planning.weights_path);
    EXPECT_EQ(a.planning.time_limit_s, b.planning.time_limit_s);
    EXPECT_EQ(a.execution.speed_limit_mps, b.execution.speed_limit_mps);
    EXPECT_EQ(a.execution.acceleration_limit_mps2, b.execution.acceleration_limit_mps2);
    EXPECT_EQ(a.execution.turn_rate_limit_radps, b.execution.turn_rate_limit_radps);
    EXPECT_EQ(a.execution.position_tolerance_m, b.execution.position_tolerance_m);
    EXPECT_EQ(a.execution.heading_tolerance_rad, b.execution.heading_tolerance_rad);
    EXPECT_EQ(a.execution.tracking_error_m, b.execution.tracking_error_m);
    EXPECT_EQ(a.execution.pose_timeout_s, b.execution.pose_timeout_s);
    EXPECT_EQ(a.execution.base_timeout_s, b.execution.base_timeout_s);
    EXPECT_EQ(a.execution.command_latency_s, b.execution.command_latency_s);
  }

  TemporaryFolder folder_;
};

TEST_F(SaveExperimentTest, WritesWhatLoadsAgain) {
  const Experiment lab = loadExperiment(folder_.path("lab.yaml"));
  saveExperiment(lab, folder_.path("saved.yaml"));
  expectSame(lab, loadExperiment(folder_.path("saved.yaml")));
}

TEST_F(SaveExperimentTest, WritesWhatLoadsAgainFromAnotherFolder) {
  const Experiment lab = loadExperiment(folder_.path("lab.yaml"));
  const TemporaryFolder elsewhere;
  saveExperiment(lab, elsewhere.path("saved.yaml"));
  expectSame(lab, loadExperiment(elsewhere.path("saved.yaml")));
}

TEST_F(SaveExperimentTest, KeepsADrawOfStartsAndGoals) {
  Experiment shipped = loadExperiment(std::string(MAPS_DIR) + "/lab_room.yaml", {7, std::nullopt});
  const TemporaryFolder elsewhere;
  saveExperiment(shipped, elsewhere.path("saved.yaml"));
  const Experiment saved = loadExperiment(elsewhere.path("saved.yaml"));
  for (std::size_t i = 0; i < shipped.robots.size(); ++i) {
    EXPECT_EQ(shipped.robots[i].start, saved.robots[i].start);
    EXPECT_EQ(shipped.robots[i].goal, saved.robots[i].goal);
  }
}

TEST_F(SaveExperimentTest, LeavesAFileAloneThatIsThere) {
  const Experiment lab = loadExperiment(folder_.path("lab.yaml"));
  expectError("/lab.yaml: is there already: choose another name or remove it",
              [&] { saveExperiment(lab, lab.path); });
  expectSame(lab, loadExperiment(lab.path));
}

TEST_F(SaveExperimentTest, NamesTheFileThatItCannotWrite) {
  const Experiment lab = loadExperiment(folder_.path("lab.yaml"));
  const std::string path = folder_.path("nowhere/saved.yaml");
  EXPECT_EQ(0U, errorOf([&] { saveExperiment(lab, path); }).find(path + ": "));
}

}  // namespace
}  // namespace sylph
