#include "sylph_core/control/drive_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace sylph {
namespace {

DrivePath pathOf(const std::vector<Point>& points, double blend_m) {
  DrivePath path(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    path.append(points[i], blend_m);
  }
  return path;
}

TEST(DrivePathTest, TellsHowItPassesEachWaypoint) {
  const DrivePath path = pathOf({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 0}}, 0.02);
  EXPECT_EQ(Corner::Stop, path.corner(0));
  EXPECT_EQ(Corner::Straight, path.corner(1));
  EXPECT_EQ(Corner::Blend, path.corner(2));
  EXPECT_EQ(Corner::Stop, path.corner(3));  // leads back
  EXPECT_EQ(Corner::Stop, path.corner(4));  // the end
}

TEST(DrivePathTest, WithoutABlendDistanceTheRobotStopsAtCorners) {
  const DrivePath path = pathOf({{0, 0}, {1, 0}, {1, 1}}, 0.0005);
  EXPECT_EQ(Corner::Stop, path.corner(1));
  EXPECT_DOUBLE_EQ(0.0, path.blendSpeed(1, 0.6));
}

TEST(DrivePathTest, BlendsOfNeighboursDoNotMeet) {
  const DrivePath path = pathOf({{0, 0}, {0.1, 0}, {0.1, 0.1}, {0.2, 0.1}}, 1.0);
  EXPECT_LT(path.blend(1) + path.blend(2), 0.1);
}

TEST(DrivePathTest, BlendSpeedIsThatOfAConstantAcceleration) {
  const DrivePath path = pathOf({{0, 0}, {1, 0}, {1, 1}}, 0.02);
  const double speed_mps = path.blendSpeed(1, 0.6);
  const double duration_s = 2.0 * 0.02 / speed_mps;
  const double acceleration_mps2 = std::sqrt(2.0) * speed_mps / duration_s;
  EXPECT_NEAR(0.6, acceleration_mps2, 1e-12);
}

TEST(DrivePathTest, DistanceToALegCountsItsEnds) {
  const DrivePath path = pathOf({{0, 0}, {1, 0}}, 0.0);
  EXPECT_DOUBLE_EQ(0.3, distanceToLeg(path.leg(0), {0.5, -0.3}));
  EXPECT_DOUBLE_EQ(0.5, distanceToLeg(path.leg(0), {-0.3, 0.4}));
  EXPECT_DOUBLE_EQ(0.5, distanceToLeg(path.leg(0), {1.3, 0.4}));
}

TEST(DrivePathTest, RefusesALegToNowhere) {
  DrivePath path({1.0, 1.0});
  EXPECT_THROW(path.append({1.0, 1.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(path.append({std::numeric_limits<double>::infinity(), 1.0}, 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace sylph
