#include "sylph_planner_node/options.hpp"

#include <string>
#include <utility>
#include <vector>

#include "sylph_ros/parameters.hpp"

namespace sylph_planner_node {

Options loadOptions(const ros::NodeHandle& private_nh) {
  Options options;
  const std::vector<std::pair<std::string, double*>> periods = {
      {"tick_period_s", &options.tick_period_s},
      {"feedback_period_s", &options.feedback_period_s},
      {"map_period_s", &options.map_period_s},
      {"resend_period_s", &options.resend_period_s},
      {"pose_timeout_s", &options.pose_timeout_s},
      {"pose_wait_s", &options.pose_wait_s},
      {"central_wait_s", &options.central_wait_s},
      {"hold_wait_s", &options.hold_wait_s},
      {"replanning_time_limit_s", &options.replanning_time_limit_s}};
  sylph_ros::read(private_nh, "ignore_unseen_robots", options.ignore_unseen_robots);
  std::vector<std::string> known = {"ignore_unseen_robots"};
  for (const auto& [name, value] : periods) {
    sylph_ros::read(private_nh, name, *value);
    sylph_ros::requirePositive(private_nh, name, *value);
    known.push_back(name);
  }
  sylph_ros::requireKnown(private_nh, known);
  return options;
}

}  // namespace sylph_planner_node
