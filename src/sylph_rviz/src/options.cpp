#include "sylph_rviz/options.hpp"

#include <limits>

#include "sylph_ros/parameters.hpp"

namespace sylph_rviz {

Options loadOptions(const ros::NodeHandle& private_nh) {
  Options options;
  sylph_ros::requireKnown(private_nh, {"rate_hz", "lifetime_s", "pose_timeout_s"});
  sylph_ros::read(private_nh, "rate_hz", options.rate_hz);
  sylph_ros::read(private_nh, "lifetime_s", options.lifetime_s);
  sylph_ros::read(private_nh, "pose_timeout_s", options.pose_timeout_s);
  sylph_ros::requireInRange(private_nh, "rate_hz", options.rate_hz, 1.0, 60.0);
  sylph_ros::requireInRange(private_nh, "lifetime_s", options.lifetime_s, 1.0 / options.rate_hz,
                            std::numeric_limits<double>::max());
  sylph_ros::requirePositive(private_nh, "pose_timeout_s", options.pose_timeout_s);
  return options;
}

}  // namespace sylph_rviz
