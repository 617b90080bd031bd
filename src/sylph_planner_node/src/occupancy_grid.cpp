#include "sylph_planner_node/occupancy_grid.hpp"

#include <cstdint>

#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {

nav_msgs::OccupancyGrid toOccupancyGrid(const sylph::Grid& grid, double cell_size_m,
                                        const sylph::Point& corner) {
  constexpr std::int8_t kFree = 0;
  constexpr std::int8_t kObstacle = 100;
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = sylph_ros::kMapFrame;
  message.info.resolution = static_cast<float>(cell_size_m);
  message.info.width = static_cast<std::uint32_t>(grid.cols());
  message.info.height = static_cast<std::uint32_t>(grid.rows());
  message.info.origin.position.x = corner.x;
  message.info.origin.position.y = corner.y;
  message.info.origin.orientation.w = 1.0;
  message.data.reserve(static_cast<std::size_t>(grid.size()));
  // OccupancyGrid counts rows from below, the grid from above.
  for (int row = grid.rows() - 1; row >= 0; --row) {
    for (int col = 0; col < grid.cols(); ++col) {
      message.data.push_back(grid.isFree({row, col}) ? kFree : kObstacle);
    }
  }
  return message;
}

}  // namespace sylph_planner_node
