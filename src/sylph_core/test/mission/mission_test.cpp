#include "sylph_core/mission/mission.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "small_lab.hpp"

namespace sylph {
namespace {

TEST(ToMissionTest, TakesAllThatThePlannerNeedsFromTheExperiment) {
  Experiment lab = smallLab();
  lab.corner = {-1.0, 2.0};
  lab.seed = 7;
  const Mission mission = toMission(lab);
  EXPECT_EQ(lab.map_path, mission.map_path);
  EXPECT_EQ(lab.grid, mission.grid);
  EXPECT_DOUBLE_EQ(0.3, mission.cell_size_m);
  EXPECT_DOUBLE_EQ(-1.0, mission.corner.x);
  EXPECT_DOUBLE_EQ(2.0, mission.corner.y);
  EXPECT_EQ((std::vector<std::string>{"robot_0", "robot_1", "robot_2"}), mission.robots);
  EXPECT_EQ((Configuration{{0, 4}, {2, 0}, {0, 0}}), mission.goals);
  EXPECT_EQ("lacam", mission.planner);
  EXPECT_DOUBLE_EQ(0.2, mission.time_limit_s);
  EXPECT_EQ(7U, mission.seed);
  EXPECT_EQ(nullptr, mission.policy);
}

}  // namespace
}  // namespace sylph
