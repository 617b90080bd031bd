#include "sylph_planner_node/occupancy_grid.hpp"

#include <gtest/gtest.h>

namespace sylph_planner_node {
namespace {

TEST(ToOccupancyGridTest, CountsRowsFromBelow) {
  const nav_msgs::OccupancyGrid map = toOccupancyGrid(sylph::Grid::fromText("#..\n..#\n"), 0.3);
  EXPECT_EQ("map", map.header.frame_id);
  EXPECT_EQ(3U, map.info.width);
  EXPECT_EQ(2U, map.info.height);
  EXPECT_FLOAT_EQ(0.3F, map.info.resolution);
  EXPECT_DOUBLE_EQ(0.0, map.info.origin.position.x);
  EXPECT_DOUBLE_EQ(1.0, map.info.origin.orientation.w);
  EXPECT_DOUBLE_EQ(-10.5,
                   toOccupancyGrid(sylph::Grid(2, 3), 0.3, {-10.5, 3.0}).info.origin.position.x);
  EXPECT_DOUBLE_EQ(3.0,
                   toOccupancyGrid(sylph::Grid(2, 3), 0.3, {-10.5, 3.0}).info.origin.position.y);
  EXPECT_EQ((std::vector<std::int8_t>{0, 0, 100, 100, 0, 0}), map.data);
}

}  // namespace
}  // namespace sylph_planner_node
