#include "sylph_core/text/join.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sylph {
namespace {

TEST(JoinTest, PutsTheWordBetweenTwoTextsOnly) {
  EXPECT_EQ("", join(std::vector<std::string>{}));
  EXPECT_EQ("cf1", join(std::vector<std::string>{"cf1"}));
  EXPECT_EQ("cf1, alpha, B", join(std::vector<std::string>{"cf1", "alpha", "B"}));
  EXPECT_EQ("cf1; alpha", join(std::vector<std::string>{"cf1", "alpha"}, "; "));
}

TEST(JoinTest, KeepsEmptyTexts) {
  EXPECT_EQ(", , B", join(std::vector<std::string>{"", "", "B"}));
}

TEST(JoinTest, WritesElementsByTheFunctionGiven) {
  EXPECT_EQ("[1, 9, 9]", "[" + join(std::vector<int>{1, 9, 9}, ", ", [](int side) {
                           return std::to_string(side);
                         }) + "]");
}

}  // namespace
}  // namespace sylph
