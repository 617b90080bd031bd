#include "sylph_planner_node/planner_watch.hpp"

#include <actionlib_msgs/GoalStatusArray.h>

#include <stdexcept>
#include <utility>

#include "sylph_core/text/format.hpp"

namespace sylph_planner_node {

PlannerWatch::PlannerWatch(const ros::NodeHandle& nh, const std::string& action, double limit_s,
                           std::string rest)
    : action_(nh.resolveName(action)),
      limit_(limit_s),
      rest_(std::move(rest)),
      heard_(std::make_shared<std::atomic<Clock::time_point>>(Clock::now())) {
  const boost::function<void(const actionlib_msgs::GoalStatusArrayConstPtr&)> note =
      [heard = heard_](const actionlib_msgs::GoalStatusArrayConstPtr&) { *heard = Clock::now(); };
  subscriber_ =
      ros::NodeHandle(nh).subscribe<actionlib_msgs::GoalStatusArray>(action_ + "/status", 1, note);
}

void PlannerWatch::requireAlive(bool is_connected) const {
  if (Clock::now() - heard_->load() <= limit_) {
    return;
  }
  if (!is_connected) {
    throw std::runtime_error("the planner is gone: nobody serves the action " + action_ +
                             " any more" + rest_);
  }
  throw std::runtime_error("the planner hangs: no status of the action " + action_ +
                           sylph::format(" for %.0f s", limit_.count()) +
                           ", or the lab's time stands still" + rest_);
}

}  // namespace sylph_planner_node
