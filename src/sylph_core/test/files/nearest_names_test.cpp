#include "sylph_core/files/nearest_names.hpp"

#include <gtest/gtest.h>

namespace sylph {
namespace {

using Names = std::vector<std::string>;

TEST(NearestNamesTest, ArePutInOrderByCharactersToChange) {
  EXPECT_EQ((Names{"robot_1", "robot_12"}),
            nearestNames("robt_1", {"alpha", "robot_12", "robot_1"}));
}

TEST(NearestNamesTest, LookAtLettersAndDigitsOnly) {
  EXPECT_EQ(Names{"robot_3"}, nearestNames("Robot3", {"robot_13", "robot_3"}, 1));
}

TEST(NearestNamesTest, AreNoMoreThanThereAre) {
  EXPECT_EQ(Names{"cf1"}, nearestNames("robot_1", {"cf1"}));
  EXPECT_TRUE(nearestNames("robot_1", {}).empty());
}

}  // namespace
}  // namespace sylph
