#include "sylph_rviz/layer_history.hpp"

#include <gtest/gtest.h>

#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

Marker dot(int id) {
  return disc({"dots", id}, {0.0, 0.0}, 0.1, 0.1, white());
}

TEST(LayerHistoryTest, WipesTheDisplayOnceAndThenDeletesById) {
  LayerHistory history;
  const auto first = history.update({dot(0), dot(1)}, 2.0, 0.0);
  ASSERT_EQ(3U, first.markers.size());
  EXPECT_EQ(Marker::DELETEALL, first.markers[0].action);
  EXPECT_DOUBLE_EQ(2.0, first.markers[1].lifetime.toSec());

  const auto second = history.update({dot(1)}, 2.0, 0.1);
  ASSERT_EQ(2U, second.markers.size());
  EXPECT_EQ(Marker::ADD, second.markers[0].action);
  EXPECT_EQ(1, second.markers[0].id);
  EXPECT_EQ(Marker::DELETE, second.markers[1].action);
  EXPECT_EQ("dots", second.markers[1].ns);
  EXPECT_EQ(0, second.markers[1].id);

  EXPECT_EQ(1U, history.update({dot(1)}, 2.0, 0.2).markers.size());
}

TEST(LayerHistoryTest, SendsAMarkerThatHasNotChangedOnlyToKeepItAlive) {
  LayerHistory history(1.0);
  EXPECT_EQ(3U, history.update({dot(0), dot(1)}, 2.0, 0.0).markers.size());
  EXPECT_TRUE(history.update({dot(0), dot(1)}, 2.0, 0.9).markers.empty());
  Marker moved = dot(1);
  moved.pose.position.x = 1.0;
  const auto changed = history.update({dot(0), moved}, 2.0, 0.95);
  ASSERT_EQ(1U, changed.markers.size());
  EXPECT_EQ(1.0, changed.markers[0].pose.position.x);
  const auto refreshed = history.update({dot(0), moved}, 2.0, 1.0);
  ASSERT_EQ(1U, refreshed.markers.size());
  EXPECT_EQ(0, refreshed.markers[0].id) << "the other one was sent a moment ago";
  history.sendAll();
  EXPECT_EQ(2U, history.update({dot(0), moved}, 2.0, 1.1).markers.size());
  EXPECT_TRUE(history.update({dot(0), moved}, 2.0, 1.2).markers.empty());
  const auto gone = history.update({moved}, 2.0, 1.3);
  ASSERT_EQ(1U, gone.markers.size());
  EXPECT_EQ(Marker::DELETE, gone.markers[0].action);
}

}  // namespace
}  // namespace sylph_rviz
