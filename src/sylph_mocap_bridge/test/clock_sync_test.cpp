#include "sylph_mocap_bridge/clock_sync.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sylph_core/grid/rng.hpp"
#include "sylph_mocap_bridge/frame_stamper.hpp"

namespace sylph_mocap_bridge {
namespace {

constexpr double kPeriodS = 1.0 / 120.0;
constexpr double kOffsetS = 1.7e9;

/// Of a network: often short, now and then long, 3 ms on average [s].
double drawDelay(sylph::Rng& rng) {
  return -0.003 * std::log(1.0 - sylph::drawFraction(rng));
}

TEST(ClockSyncTest, KnowsNothingBeforeEnoughFrames) {
  ClockSync clock{ClockSyncOptions()};
  for (std::size_t i = 0; i + 1 < ClockSyncOptions().least_samples; ++i) {
    clock.add(static_cast<double>(i), static_cast<double>(i));
    EXPECT_FALSE(clock.toLocal(0.0));
  }
  clock.add(50.0, 50.0);
  EXPECT_TRUE(clock.toLocal(0.0));
}

TEST(ClockSyncTest, TheLeastDelayShowsTheOffsetUnderJitter) {
  sylph::Rng rng(1);
  ClockSync clock{ClockSyncOptions()};
  for (int i = 0; i < 2000; ++i) {
    const double server_s = 100.0 + i * kPeriodS;
    clock.add(server_s, server_s + kOffsetS + 0.0002 + drawDelay(rng));
  }
  EXPECT_NEAR(kOffsetS + 0.0002, clock.estimate()->offset_s, 1e-4);
}

TEST(ClockSyncTest, StampsKeepTheServersRhythm) {
  sylph::Rng rng(2);
  ClockSync clock{ClockSyncOptions()};
  std::optional<double> last_s;
  for (int i = 0; i < 3000; ++i) {
    const double server_s = i * kPeriodS;
    clock.add(server_s, server_s + kOffsetS + drawDelay(rng));
    const std::optional<double> stamp_s = clock.toLocal(server_s);
    if (stamp_s && last_s) {
      ASSERT_NEAR(kPeriodS, *stamp_s - *last_s, 0.002 * kPeriodS + 1e-6) << i;
    }
    last_s = stamp_s;
  }
}

TEST(ClockSyncTest, TheMedianServesAClockThatMovesInSteps) {
  // Simulated time is published every 20 ms; frames come at any time between.
  ClockSyncOptions options;
  options.quantile = 0.5;
  ClockSync clock(options);
  for (int i = 0; i < 3000; ++i) {
    const double server_s = i * kPeriodS;
    clock.add(server_s, std::floor(server_s / 0.02 + 1e-9) * 0.02);
  }
  EXPECT_NEAR(-0.01, clock.estimate()->offset_s, 0.003);
}

TEST(ClockSyncTest, FollowsClocksThatDriftApart) {
  ClockSync clock{ClockSyncOptions()};
  double server_s = 0.0;
  for (int i = 0; i < 120 * 120; ++i) {
    server_s = i * kPeriodS;
    clock.add(server_s, server_s * (1.0 + 50e-6));
  }
  EXPECT_NEAR(server_s * (1.0 + 50e-6), *clock.toLocal(server_s), 0.001);
}

TEST(ClockSyncTest, AClockThatIsSetIsFollowedAtOnce) {
  ClockSync clock{ClockSyncOptions()};
  for (int i = 0; i < 200; ++i) {
    clock.add(i * kPeriodS, i * kPeriodS);
  }
  for (int i = 200; i < 2000; ++i) {
    clock.add(i * kPeriodS, i * kPeriodS + 100.0);
  }
  EXPECT_NEAR(100.0, clock.estimate()->offset_s, 1e-9);
}

TEST(ClockSyncTest, GoodEchoesCountMoreThanFrames) {
  ClockSync clock{ClockSyncOptions()};
  for (int i = 0; i < 100; ++i) {
    clock.add(i * kPeriodS, i * kPeriodS + 0.004, sylph_natnet::ClockEstimate{0.001, 0.0002});
  }
  EXPECT_NEAR(0.001, clock.estimate()->offset_s, 1e-9);
  EXPECT_NEAR(0.0002, clock.estimate()->uncertainty_s, 1e-9);
}

TEST(ClockSyncTest, PoorEchoesDoNot) {
  ClockSync clock{ClockSyncOptions()};
  for (int i = 0; i < 100; ++i) {
    clock.add(i * kPeriodS, i * kPeriodS + 0.004, sylph_natnet::ClockEstimate{-0.05, 0.08});
  }
  EXPECT_NEAR(0.004, clock.estimate()->offset_s, 1e-9);
}

TEST(ClockSyncTest, ResetForgets) {
  ClockSync clock{ClockSyncOptions()};
  for (int i = 0; i < 100; ++i) {
    clock.add(i * kPeriodS, i * kPeriodS);
  }
  clock.reset();
  EXPECT_FALSE(clock.estimate());
}

sylph_natnet::Frame frameWithTicks() {
  sylph_natnet::Frame frame;
  frame.timestamp_s = 3.0;
  frame.mid_exposure_ticks = 1'000'000;
  frame.data_received_ticks = 1'046'000;
  frame.transmit_ticks = 1'055'000;
  return frame;
}

TEST(FrameStamperTest, TicksTellExposureAndTransmission) {
  const FrameTimes times = timesOf(frameWithTicks(), 10'000'000);
  EXPECT_DOUBLE_EQ(0.1, times.exposure_s);
  EXPECT_DOUBLE_EQ(0.1055, times.transmit_s);
}

TEST(FrameStamperTest, AnUnknownExposureIsTheNextInstantThatIsKnown) {
  sylph_natnet::Frame frame = frameWithTicks();
  frame.mid_exposure_ticks = 0;
  EXPECT_DOUBLE_EQ(0.1046, timesOf(frame, 10'000'000).exposure_s);
  frame.data_received_ticks = 0;
  EXPECT_DOUBLE_EQ(0.1055, timesOf(frame, 10'000'000).exposure_s);
}

TEST(FrameStamperTest, Before30TimestampAndLatencyTell) {
  sylph_natnet::Frame frame;
  frame.timestamp_s = 3.0;
  frame.latency_s = 0.005F;
  EXPECT_DOUBLE_EQ(3.0, timesOf(frame, 0).exposure_s);
  EXPECT_NEAR(3.005, timesOf(frame, 0).transmit_s, 1e-7);
}

TEST(FrameStamperTest, ThreePoliciesMeanThreeInstants) {
  FrameStamper receive(StampPolicy::Receive, {});
  FrameStamper compensated(StampPolicy::LatencyCompensated, {});
  FrameStamper synced(StampPolicy::ClockSync, {});
  std::optional<double> synced_s;
  FrameTimes times;
  for (int i = 0; i < 100; ++i) {
    times.exposure_s = i * kPeriodS;
    times.transmit_s = times.exposure_s + 0.0055;
    const double delay_s = i % 2 == 0 ? 0.001 : 0.004;  // ends with the long one
    const double arrival_s = times.transmit_s + 50.0 + delay_s;
    EXPECT_DOUBLE_EQ(arrival_s, *receive.stamp(times, arrival_s, std::nullopt));
    EXPECT_DOUBLE_EQ(arrival_s - 0.0055, *compensated.stamp(times, arrival_s, std::nullopt));
    synced_s = synced.stamp(times, arrival_s, std::nullopt);
  }
  ASSERT_TRUE(synced_s);
  EXPECT_NEAR(times.exposure_s + 50.001, *synced_s, 1e-9);
}

}  // namespace
}  // namespace sylph_mocap_bridge
