#include "sylph_training/run/policy_meters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "test/support/random_weights.hpp"

namespace sylph_training {
namespace {

MeterSettings quick() {
  MeterSettings settings;
  settings.worlds = 1;
  settings.steps = 12;
  return settings;
}

const MeterWorlds kMaze = {MeterWorlds::Family::Maze, 32};
const MeterWorlds kCrowded = {MeterWorlds::Family::Random, 200};

TEST(PolicyMetersTest, AreSharesAndTheSameForTheSameSeed) {
  const PolicyMeters meters = measure(*sylph::randomPolicy(), kCrowded, quick());
  EXPECT_EQ(1, meters.worlds);
  EXPECT_EQ(0, meters.solved);
  EXPECT_GT(meters.non_greedy, 0.0);
  EXPECT_GT(meters.pairs, 0);
  for (const auto& [name, value] : meters.figures()) {
    EXPECT_GE(value, 0.0) << name;
    EXPECT_LE(value, name == "svo_error_deg" ? 45.0 : 1.0) << name;
  }
  EXPECT_EQ(meters.figures(), measure(*sylph::randomPolicy(), kCrowded, quick()).figures());
}

TEST(PolicyMetersTest, APolicyThatAlwaysStaysGivesWayAlwaysAndAwayNever) {
  sylph::TensorFile weights = sylph::RandomWeights(sylph::smallShape(), 1).file();
  weights.tensors["heads.action.bias"].values[0] = 1000.F;
  const PolicyMeters meters = measure(sylph::Policy(weights, "stays"), kCrowded, quick());
  EXPECT_EQ(1.0, meters.recall);
  EXPECT_EQ(0.0, meters.away_recall);
  EXPECT_EQ(0.0, meters.away_precision);
  EXPECT_NEAR(meters.non_greedy, meters.precision, 1e-9);
  EXPECT_EQ(0.0, meters.svo_sensitivity);
  EXPECT_EQ(0, meters.head_on_roles) << "nobody pushes";
}

TEST(PolicyMetersTest, SvosByTheRuleAreNoDistanceFromTheRule) {
  MeterSettings settings = quick();
  settings.svo = sylph::SvoChoice::Priority;
  EXPECT_EQ(0.0, measure(*sylph::randomPolicy(), kMaze, settings).svo_error_deg);
  settings.svo = sylph::SvoChoice::Mean;
  EXPECT_GT(measure(*sylph::randomPolicy(), kMaze, settings).svo_error_deg, 1.0);
}

TEST(MeterWorldsTest, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const MeterWorlds& worlds : meterWorlds()) {
    names.insert(worlds.name());
  }
  EXPECT_EQ(meterWorlds().size(), names.size());
  EXPECT_EQ(1U, names.count("maze_32"));
}

}  // namespace
}  // namespace sylph_training
