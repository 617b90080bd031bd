#include "sylph_core/text/format.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sylph {
namespace {

TEST(FormatTest, WritesANumberAmongItsWords) {
  EXPECT_EQ("waits 1.3 s", format("waits %.1f s", 1.26));
  EXPECT_EQ("3 mm", format("%.0f mm", 3.2));
  EXPECT_EQ("nan", format("%.2f", std::nan("")));
}

TEST(FormatTest, CutsOffWhatIsTooLong) {
  EXPECT_EQ(255U, format("%.300f", 0.5).size());
}

}  // namespace
}  // namespace sylph
