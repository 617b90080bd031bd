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
  const auto first = history.update({dot(0), dot(1)}, 2.0);
  ASSERT_EQ(3U, first.markers.size());
  EXPECT_EQ(Marker::DELETEALL, first.markers[0].action);
  EXPECT_DOUBLE_EQ(2.0, first.markers[1].lifetime.toSec());

  const auto second = history.update({dot(1)}, 2.0);
  ASSERT_EQ(2U, second.markers.size());
  EXPECT_EQ(Marker::ADD, second.markers[0].action);
  EXPECT_EQ(1, second.markers[0].id);
  EXPECT_EQ(Marker::DELETE, second.markers[1].action);
  EXPECT_EQ("dots", second.markers[1].ns);
  EXPECT_EQ(0, second.markers[1].id);

  EXPECT_EQ(1U, history.update({dot(1)}, 2.0).markers.size());
}

}  // namespace
}  // namespace sylph_rviz
