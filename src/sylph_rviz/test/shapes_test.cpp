#include "sylph_rviz/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sylph_ros/conversions.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

double doubleArea(const Marker& marker, std::size_t first) {
  const auto& a = marker.points[first];
  const auto& b = marker.points[first + 1];
  const auto& c = marker.points[first + 2];
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(TrianglesTest, FaceTheCameraWhateverTheOrderOfTheirCorners) {
  const Marker marker =
      triangles({"t", 0}, {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 1}, {1, 0}}, 0.1, white());
  ASSERT_EQ(6U, marker.points.size());
  EXPECT_GT(doubleArea(marker, 0), 0.0);
  EXPECT_GT(doubleArea(marker, 3), 0.0);
}

TEST(MakeMarkerTest, IsDrawnAtTheLatestTransform) {
  const Marker marker = makeMarker({"ns", 3}, Marker::CUBE, white());
  EXPECT_EQ("map", marker.header.frame_id);
  EXPECT_TRUE(marker.header.stamp.isZero());
  EXPECT_EQ("ns", marker.ns);
  EXPECT_EQ(3, marker.id);
  EXPECT_DOUBLE_EQ(1.0, marker.pose.orientation.w);
}

TEST(BentLineTest, BendsToTheLeftSoThatOppositeArrowsAreApart) {
  const auto there = bentLine({0.0, 0.0}, {2.0, 0.0}, 0.1);
  const auto back = bentLine({2.0, 0.0}, {0.0, 0.0}, 0.1);
  const std::size_t middle = there.size() / 2;
  EXPECT_GT(there[middle].y, 0.1);
  EXPECT_LT(back[middle].y, -0.1);
  EXPECT_NEAR(0.1, there.front().x, 1e-9);
  EXPECT_NEAR(1.9, there.back().x, 1e-9);
}

TEST(BentLineTest, KeepsAThirdOfItsWayHoweverNearTheEndsAre) {
  const auto line = bentLine({0.0, 0.0}, {0.15, 0.0}, 0.1);
  EXPECT_NEAR(0.05, line.back().x - line.front().x, 1e-9);
}

TEST(BentLineTest, OfNoLengthIsFinite) {
  for (const sylph::Point& point : bentLine({1.0, 1.0}, {1.0, 1.0}, 0.1)) {
    EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
  }
}

TEST(DashesTest, LieBetweenTheGapsInPairs) {
  const auto points = dashes({0.0, 0.0}, {1.0, 0.0}, 0.1, 0.05);
  ASSERT_FALSE(points.empty());
  ASSERT_EQ(0U, points.size() % 2);
  for (std::size_t i = 0; i < points.size(); i += 2) {
    EXPECT_LT(points[i].x, points[i + 1].x);
    EXPECT_GE(points[i].x, 0.1 - 1e-9);
    EXPECT_LE(points[i + 1].x, 0.9 + 1e-9);
  }
  EXPECT_TRUE(dashes({1.0, 1.0}, {1.0, 1.0}, 0.1, 0.05).empty());
}

TEST(TextFromTest, BeginsWhereItIsTold) {
  const Marker narrow = textFrom({"t", 0}, {1.0, 2.0}, 0.1, 0.2, "ill", white());
  const Marker wide = textFrom({"t", 0}, {1.0, 2.0}, 0.1, 0.2, "MMM", white());
  EXPECT_GT(narrow.pose.position.x, 1.0);
  EXPECT_GT(wide.pose.position.x, narrow.pose.position.x);
  EXPECT_DOUBLE_EQ(2.0, wide.pose.position.y);
}

TEST(WrappedTest, BreaksAtSpacesAndKeepsLongWordsWhole) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ((Lines{"one two", "three"}), wrapped("one two three", 8));
  EXPECT_EQ((Lines{"a", "incomprehensible", "b"}), wrapped("a incomprehensible b", 5));
  EXPECT_EQ(Lines{}, wrapped("", 5));
}

TEST(AttachTest, KeepsTheDirectionsOfTheMapOnARobotThatIsTurned) {
  RobotView robot;
  robot.name = "robot_4";
  robot.pose = sylph::Pose2d{5.0, 6.0, 1.5707963267948966};
  const Marker marker = attach(disc({"d", 0}, {0.0, 0.2}, 0.1, 0.1, white()), robot);
  EXPECT_EQ("robot_4", marker.header.frame_id);
  EXPECT_TRUE(marker.frame_locked);
  EXPECT_TRUE(marker.header.stamp.isZero());
  // The robot faces north: what lies north of it is in front of it.
  EXPECT_NEAR(0.2, marker.pose.position.x, 1e-9);
  EXPECT_NEAR(0.0, marker.pose.position.y, 1e-9);
  EXPECT_NEAR(-1.5707963267948966, sylph_ros::yawOf(marker.pose.orientation), 1e-9);
}

TEST(AttachTest, TurnsWithTheRobotIfAsked) {
  RobotView robot;
  robot.pose = sylph::Pose2d{5.0, 6.0, 1.0};
  const Marker marker = attach(disc({"d", 0}, {0.1, 0.0}, 0.1, 0.1, white()), robot, true);
  EXPECT_DOUBLE_EQ(0.1, marker.pose.position.x);
  EXPECT_DOUBLE_EQ(0.0, sylph_ros::yawOf(marker.pose.orientation));
}

TEST(PaletteTest, GivesEightRobotsDifferentColorsAndThenRepeats) {
  for (std::size_t a = 0; a < 8; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_FALSE(robotColor(a) == robotColor(b)) << a << " " << b;
    }
  }
  EXPECT_TRUE(robotColor(0) == robotColor(8));
}

TEST(PaletteTest, SvoGrowsBrighter) {
  float before = 0.0F;
  for (int svo_deg = 0; svo_deg <= 45; svo_deg += 5) {
    const auto color = svoColor(svo_deg);
    const float luminance = 0.2126F * color.r + 0.7152F * color.g + 0.0722F * color.b;
    EXPECT_GT(luminance, before) << svo_deg;
    before = luminance;
  }
  EXPECT_TRUE(svoColor(-10.0) == svoColor(0.0));
  EXPECT_TRUE(svoColor(90.0) == svoColor(45.0));
}

}  // namespace
}  // namespace sylph_rviz
