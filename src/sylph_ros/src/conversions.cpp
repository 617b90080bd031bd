#include "sylph_ros/conversions.hpp"

#include <cmath>

namespace sylph_ros {

sylph_msgs::Cell toMessage(const sylph::Cell& cell) {
  sylph_msgs::Cell message;
  message.row = cell.row;
  message.col = cell.col;
  return message;
}

std::vector<sylph_msgs::Cell> toMessage(const std::vector<sylph::Cell>& cells) {
  std::vector<sylph_msgs::Cell> messages;
  messages.reserve(cells.size());
  for (const sylph::Cell& cell : cells) {
    messages.push_back(toMessage(cell));
  }
  return messages;
}

sylph::Cell fromMessage(const sylph_msgs::Cell& message) {
  return {message.row, message.col};
}

std::uint8_t toMessage(sylph::Action action) {
  return static_cast<std::uint8_t>(action);
}

std::optional<sylph::Action> actionFromMessage(std::uint8_t action) {
  if (action >= sylph::kActionCount) {
    return std::nullopt;
  }
  return static_cast<sylph::Action>(action);
}

geometry_msgs::Point toMessage(const sylph::Point& point) {
  geometry_msgs::Point message;
  message.x = point.x;
  message.y = point.y;
  return message;
}

geometry_msgs::Quaternion quaternionFromYaw(double yaw_rad) {
  geometry_msgs::Quaternion quaternion;
  quaternion.z = std::sin(yaw_rad / 2.0);
  quaternion.w = std::cos(yaw_rad / 2.0);
  return quaternion;
}

double yawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

}  // namespace sylph_ros
