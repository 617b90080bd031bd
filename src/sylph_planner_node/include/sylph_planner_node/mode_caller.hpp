#pragma once

#include <ros/node_handle.h>

#include <future>
#include <optional>
#include <string>

namespace sylph_planner_node {

/// Asks the central node to pause or to resume without blocking the caller.
class ModeCaller {
 public:
  explicit ModeCaller(const ros::NodeHandle& nh) : nh_(nh) {}

  /// Robots finish the tasks that they have.
  void pause();
  /// Robots go on.
  void resume();

  /// The reason if a call has failed since the last time that this was asked.
  std::optional<std::string> takeError();

 private:
  void call(const std::string& service);

  ros::NodeHandle nh_;
  std::future<std::string> answer_;  ///< empty: done
};

}  // namespace sylph_planner_node
