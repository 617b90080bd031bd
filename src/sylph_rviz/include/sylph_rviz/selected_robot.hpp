#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace sylph_rviz {

/// The robot that the operator looks at. All who know it tell those who come later, so that a node
/// that is started again and a new panel show the same; a latch would keep what its own node said
/// last, although another has selected since.
class SelectedRobot {
 public:
  using Listener = std::function<void(const std::string&)>;

  /// @param suite_nh  in the suite's namespace
  /// @param on_heard  is told each selection, those of set() too, from the callback queue of
  ///                  `suite_nh`; an empty name is none
  SelectedRobot(const ros::NodeHandle& suite_nh, Listener on_heard);

  /// Tells everybody; empty: none.
  void set(const std::string& robot);

 private:
  void keep(const std::string& robot);
  void tellNewcomer(const ros::SingleSubscriberPublisher& newcomer) const;

  ros::NodeHandle nh_;
  Listener on_heard_;
  mutable std::mutex mutex_;  ///< of the robot
  std::optional<std::string> robot_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace sylph_rviz
