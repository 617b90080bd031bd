#include "sylph_natnet/echo_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sylph_natnet {
namespace {

TEST(EchoClockTest, KnowsNothingBeforeTheFirstEcho) {
  EXPECT_FALSE(EchoClock().estimate(0.0));
}

TEST(EchoClockTest, OneEchoShowsTheOffsetToHalfItsRoundTrip) {
  EchoClock clock;
  clock.add({100.0, 7.001, 100.002});
  EXPECT_NEAR(93.0, clock.estimate(100.002)->offset_s, 1e-9);
  EXPECT_NEAR(0.001, clock.estimate(100.002)->uncertainty_s, 1e-9);
}

TEST(EchoClockTest, TheUncertaintyGrowsWithAge) {
  EchoClock clock;
  clock.add({100.0, 7.001, 100.002});
  EXPECT_NEAR(0.001 + 60.0 * 50e-6, clock.estimate(160.002)->uncertainty_s, 1e-9);
}

TEST(EchoClockTest, StaysWithinItsUncertaintyUnderJitterAndDrift) {
  constexpr double kOffset = -1234.5;
  constexpr double kDrift = 20e-6;  // of the 50e-6 that it allows
  std::mt19937 rng(5);
  std::exponential_distribution<double> delay_s(1.0 / 0.002);
  EchoClock clock;
  for (int i = 0; i < 300; ++i) {
    const double sent_s = 1000.0 + i;
    const double arrival_s = sent_s + 0.0001 + delay_s(rng);
    const double received_s = arrival_s + 0.0001 + delay_s(rng);
    clock.add({sent_s, (arrival_s - kOffset) * (1.0 + kDrift), received_s});
    const ClockEstimate estimate = *clock.estimate(received_s);
    const double truth_s = received_s - (received_s - kOffset) * (1.0 + kDrift);
    ASSERT_LE(std::abs(estimate.offset_s - truth_s), estimate.uncertainty_s + 1e-9) << i;
    if (i > 20) {
      ASSERT_LT(estimate.uncertainty_s, 0.002) << i;
    }
  }
}

TEST(EchoClockTest, AClockThatJumpsBeginsANewHistory) {
  EchoClock clock;
  for (int i = 0; i < 10; ++i) {
    clock.add({100.0 + i, 7.0 + i, 100.0 + i + 1e-4});
  }
  clock.add({110.0, 500.0, 110.02});
  EXPECT_NEAR(-389.99, clock.estimate(110.02)->offset_s, 1e-6);
  EXPECT_NEAR(0.01, clock.estimate(110.02)->uncertainty_s, 1e-6);
}

TEST(EchoClockTest, AnAnswerBeforeItsRequestIsIgnored) {
  EchoClock clock;
  clock.add({100.0, 7.0, 99.0});
  clock.add({100.0, 7.0, std::nan("")});
  EXPECT_FALSE(clock.estimate(100.0));
}

}  // namespace
}  // namespace sylph_natnet
