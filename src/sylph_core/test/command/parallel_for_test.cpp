#include "sylph_core/command/parallel_for.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph {
namespace {

TEST(ParallelForTest, DoesEachOnceAndCountsThemUp) {
  std::vector<int> calls(100, 0);
  std::vector<std::size_t> counted;
  parallelFor(
      calls.size(), 3, [&](std::size_t index) { ++calls[index]; },
      [&](std::size_t, std::size_t done) { counted.push_back(done); });
  EXPECT_EQ(std::vector<int>(100, 1), calls);
  ASSERT_EQ(100U, counted.size());
  for (std::size_t i = 0; i < counted.size(); ++i) {
    EXPECT_EQ(i + 1, counted[i]);
  }
}

TEST(ParallelForTest, ThrowsWhatACallThrewAndBeginsNoFurtherOne) {
  std::vector<int> calls(100, 0);
  const auto failAtThree = [&](std::size_t index) {
    ++calls[index];
    if (index == 3) {
      throw std::runtime_error("three");
    }
  };
  EXPECT_THROW(parallelFor(calls.size(), 1, failAtThree, [](std::size_t, std::size_t) {}),
               std::runtime_error);
  EXPECT_EQ(1, calls[3]);
  EXPECT_EQ(0, calls[4]);
}

}  // namespace
}  // namespace sylph
