#include "sylph_mocap_bridge/frame_transform.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "sylph_core/grid/rng.hpp"

namespace sylph_mocap_bridge {
namespace {

constexpr double kTolerance = 1e-12;
const Eigen::Vector4d kUpright(0.0, 0.0, 0.0, 1.0);

/// x, y, z, w of a turn by `yaw_rad` about the up axis of Y-up axes.
Eigen::Vector4d turnedAboutY(double yaw_rad) {
  return {0.0, std::sin(yaw_rad / 2.0), 0.0, std::cos(yaw_rad / 2.0)};
}

TEST(FrameTransformTest, ZUpIsLeftAlone) {
  const FrameTransform transform(UpAxis::Z, {});
  const auto pose = transform.mapFromRobot({1.0, 2.0, 3.0}, {0.0, 0.0, 0.6, 0.8}, {});
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->position_m.isApprox(Eigen::Vector3d(1.0, 2.0, 3.0)));
  EXPECT_NEAR(2.0 * std::atan2(0.6, 0.8), yawOf(*pose), kTolerance);
}

TEST(FrameTransformTest, YUpTurnsUpToUpAndKeepsTheHeading) {
  const FrameTransform transform(UpAxis::Y, {});
  const auto pose = transform.mapFromRobot({1.0, 2.0, 3.0}, turnedAboutY(0.7), {});
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->position_m.isApprox(Eigen::Vector3d(1.0, -3.0, 2.0)));
  EXPECT_NEAR(0.7, yawOf(*pose), kTolerance);
  EXPECT_NEAR(1.0, (pose->orientation * Eigen::Vector3d::UnitZ()).z(), kTolerance);
}

TEST(FrameTransformTest, BothAxesTellTheSamePoses) {
  sylph::Rng rng(11);
  const auto draw = [&] { return sylph::drawNormal(rng); };
  for (int round = 0; round < 200; ++round) {
    const Eigen::Vector3d p(draw(), draw(), draw());
    const Eigen::Vector4d q = Eigen::Vector4d(draw(), draw(), draw(), draw()).normalized();
    const sylph::Pose2d map_from_mocap{draw(), draw(), draw()};
    const sylph::Pose2d body_from_robot{draw(), draw(), draw()};
    // (x, y, z) in Z-up axes is (x, z, -y) in Y-up ones, the vector of a rotation alike.
    const auto z_up = FrameTransform(UpAxis::Z, map_from_mocap).mapFromRobot(p, q, body_from_robot);
    const auto y_up =
        FrameTransform(UpAxis::Y, map_from_mocap)
            .mapFromRobot({p.x(), p.z(), -p.y()}, {q.x(), q.z(), -q.y(), q.w()}, body_from_robot);
    ASSERT_TRUE(z_up && y_up);
    EXPECT_TRUE(z_up->position_m.isApprox(y_up->position_m));
    EXPECT_TRUE(z_up->orientation.isApprox(y_up->orientation));
  }
}

TEST(FrameTransformTest, TheCamerasOriginIsPlacedOnTheMap) {
  const FrameTransform transform(UpAxis::Z, {10.0, 20.0, M_PI_2});
  const auto pose = transform.mapFromRobot({1.0, 0.0, 0.0}, kUpright, {});
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->position_m.isApprox(Eigen::Vector3d(10.0, 21.0, 0.0)));
  EXPECT_NEAR(M_PI_2, yawOf(*pose), kTolerance);
}

TEST(FrameTransformTest, TheRobotIsPlacedInItsBody) {
  const FrameTransform transform(UpAxis::Z, {});
  // The body looks along y; the robot's centre is 0.1 m ahead of the body's, turned back by 90.
  const auto pose = transform.mapFromRobot(
      {1.0, 1.0, 0.0}, {0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)}, {0.1, 0.0, -M_PI_2});
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->position_m.isApprox(Eigen::Vector3d(1.0, 1.1, 0.0)));
  EXPECT_NEAR(0.0, yawOf(*pose), kTolerance);
}

TEST(FrameTransformTest, OrientationsAreMadeUnit) {
  const FrameTransform transform(UpAxis::Z, {});
  const auto pose = transform.mapFromRobot({0.0, 0.0, 0.0}, 0.95 * kUpright, {});
  ASSERT_TRUE(pose);
  EXPECT_NEAR(1.0, pose->orientation.norm(), kTolerance);
}

TEST(FrameTransformTest, WhatIsNoPoseIsRefused) {
  const FrameTransform transform(UpAxis::Y, {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(transform.mapFromRobot({nan, 0.0, 0.0}, kUpright, {}));
  EXPECT_FALSE(transform.mapFromRobot({0.0, infinity, 0.0}, kUpright, {}));
  EXPECT_FALSE(transform.mapFromRobot({0.0, 0.0, 0.0}, {0.0, nan, 0.0, 1.0}, {}));
  EXPECT_FALSE(transform.mapFromRobot({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {}));
  EXPECT_FALSE(transform.mapFromRobot({0.0, 0.0, 0.0}, 1.2 * kUpright, {}));
}

}  // namespace
}  // namespace sylph_mocap_bridge
