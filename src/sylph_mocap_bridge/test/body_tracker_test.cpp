#include "sylph_mocap_bridge/body_tracker.hpp"

#include <gtest/gtest.h>

#include "sylph_core/grid/rng.hpp"

namespace sylph_mocap_bridge {
namespace {

constexpr double kPeriodS = 1.0 / 120.0;

Pose poseAt(double x_m, double y_m, double yaw_rad) {
  return toPose({x_m, y_m, yaw_rad});
}

TEST(BodyTrackerTest, TellsNoVelocityBeforeItHasSeenEnough) {
  BodyTracker tracker{TrackerOptions()};
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(tracker.update(poseAt(0.0, 0.0, 0.0), i * kPeriodS)) << i;
  }
  EXPECT_TRUE(tracker.update(poseAt(0.0, 0.0, 0.0), 4 * kPeriodS));
}

TEST(BodyTrackerTest, FindsAConstantVelocity) {
  BodyTracker tracker{TrackerOptions()};
  std::optional<Velocity> velocity;
  for (int i = 0; i < 60; ++i) {
    const double t = i * kPeriodS;
    velocity = tracker.update(poseAt(1.0 + 0.25 * t, 2.0 - 0.1 * t, 0.5 * t), t);
  }
  ASSERT_TRUE(velocity);
  EXPECT_NEAR(0.25, velocity->x_mps, 1e-3);
  EXPECT_NEAR(-0.1, velocity->y_mps, 1e-3);
  EXPECT_NEAR(0.5, velocity->yaw_radps, 2e-3);
}

TEST(BodyTrackerTest, FollowsAHeadingThroughPi) {
  BodyTracker tracker{TrackerOptions()};
  std::optional<Velocity> velocity;
  for (int i = 0; i < 240; ++i) {
    const double t = i * kPeriodS;
    velocity = tracker.update(poseAt(0.0, 0.0, 3.0 + t), t);
  }
  ASSERT_TRUE(velocity);
  EXPECT_NEAR(1.0, velocity->yaw_radps, 5e-3);
}

TEST(BodyTrackerTest, ItsVarianceIsThatOfItsErrors) {
  const TrackerOptions options;
  sylph::Rng rng(3);
  BodyTracker tracker(options);
  double x_m = 0.0;
  double speed_mps = 0.0;
  double normalised_errors = 0.0;
  int count = 0;
  for (int i = 0; i < 20000; ++i) {
    const double a = options.acceleration_sigma_mps2 * sylph::drawNormal(rng) -
                     0.2 * speed_mps;  // kept from running away
    x_m += speed_mps * kPeriodS + 0.5 * a * kPeriodS * kPeriodS;
    speed_mps += a * kPeriodS;
    const double noise_m = options.position_sigma_m * sylph::drawNormal(rng);
    const auto velocity = tracker.update(poseAt(x_m + noise_m, 0.0, 0.0), i * kPeriodS);
    if (velocity && i > 100) {
      const double error = velocity->x_mps - speed_mps;
      normalised_errors += error * error / velocity->linear_variance;
      ++count;
    }
  }
  // 1 if the filter knows how wrong it is.
  EXPECT_NEAR(1.0, normalised_errors / count, 0.15);
}

TEST(BodyTrackerTest, BeginsAnewAfterAGap) {
  const TrackerOptions options;
  BodyTracker tracker(options);
  double t = 0.0;
  for (int i = 0; i < 20; ++i, t += kPeriodS) {
    tracker.update(poseAt(0.25 * t, 0.0, 0.0), t);
  }
  EXPECT_FALSE(tracker.update(poseAt(0.25 * t, 0.0, 0.0), t + options.largest_gap_s));
}

TEST(BodyTrackerTest, AJumpIsNoVelocity) {
  BodyTracker tracker{TrackerOptions()};
  double t = 0.0;
  for (int i = 0; i < 20; ++i, t += kPeriodS) {
    tracker.update(poseAt(0.0, 0.0, 0.0), t);
  }
  for (int i = 0; i < 4; ++i, t += kPeriodS) {
    EXPECT_FALSE(tracker.update(poseAt(0.5, 0.0, 0.0), t));
  }
  const auto velocity = tracker.update(poseAt(0.5, 0.0, 0.0), t);
  ASSERT_TRUE(velocity);
  EXPECT_NEAR(0.0, velocity->x_mps, 1e-6);
}

TEST(BodyTrackerTest, TimeThatGoesBackBeginsAnew) {
  BodyTracker tracker{TrackerOptions()};
  for (int i = 0; i < 20; ++i) {
    tracker.update(poseAt(0.0, 0.0, 0.0), 10.0 + i * kPeriodS);
  }
  EXPECT_FALSE(tracker.update(poseAt(0.0, 0.0, 0.0), 1.0));
}

}  // namespace
}  // namespace sylph_mocap_bridge
