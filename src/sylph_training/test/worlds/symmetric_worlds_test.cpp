#include "sylph_training/worlds/symmetric_worlds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace sylph_training {
namespace {

using sylph::Cell;

TEST(SymmetricWorldsTest, AreCorridorsWithRecessesOrWithCrossbars) {
  const sylph::Instance recesses = recessWorld(7, 2);
  EXPECT_EQ("##.####\n.......\n####.##\n", recesses.grid.toText());
  EXPECT_EQ((sylph::Configuration{{1, 0}, {1, 6}}), recesses.starts);
  EXPECT_EQ((sylph::Configuration{{1, 6}, {1, 0}}), recesses.goals);
  EXPECT_EQ(".###.\n.....\n.###.\n", iShapedWorld(5).grid.toText());
}

TEST(SymmetricWorldsTest, LookTheSameToBothAgents) {
  sylph::Rng rng(4);
  int recesses = 0;
  for (int draw = 0; draw < 1000; ++draw) {
    const sylph::Instance world = symmetricWorld({}, rng);
    requireValid(world);
    std::string turned = world.grid.toText();
    turned.pop_back();
    std::reverse(turned.begin(), turned.end());
    ASSERT_EQ(world.grid.toText(), turned + "\n");
    EXPECT_EQ(world.starts[0], world.goals[1]);
    EXPECT_EQ(world.starts[1], world.goals[0]);
    EXPECT_GE(world.grid.cols(), 5);
    EXPECT_LE(world.grid.cols(), 11);
    recesses += world.grid.isFree({0, 0}) ? 0 : 1;
  }
  EXPECT_NEAR(800, recesses, 50);
}

TEST(SymmetricWorldsTest, RefuseCorridorsThatAreTooShort) {
  sylph::Rng rng(0);
  EXPECT_THROW(recessWorld(4, 1), std::invalid_argument);
  EXPECT_THROW(recessWorld(7, 4), std::invalid_argument);
  EXPECT_THROW(iShapedWorld(2), std::invalid_argument);
  EXPECT_THROW(symmetricWorld({1.5, 5, 11}, rng), std::invalid_argument);
  EXPECT_THROW(symmetricWorld({0.8, 9, 8}, rng), std::invalid_argument);
}

}  // namespace
}  // namespace sylph_training
