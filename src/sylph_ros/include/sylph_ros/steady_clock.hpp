#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <ros/time.h>
#include <ros/transport_hints.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "sylph_ros/lock_step.hpp"

namespace sylph_ros {

/// A publisher whose messages are counted where the lab is simulated in lock step.
class Publisher {
 public:
  Publisher() = default;
  Publisher(const ros::Publisher& publisher, std::shared_ptr<LockStep> lock_step)
      : publisher_(publisher), lock_step_(std::move(lock_step)) {}

  /// Sends a message, and counts it for those who have to wait for it.
  template <typename Message>
  void publish(const Message& message) const {
    if (lock_step_) {
      lock_step_->countMessage(publisher_.getTopic());
    }
    publisher_.publish(message);
  }
  /// Its name, resolved.
  std::string getTopic() const { return publisher_.getTopic(); }

 private:
  ros::Publisher publisher_;
  std::shared_ptr<LockStep> lock_step_;
};

/// A timer that runs as long as it is held.
class Timer {
 public:
  Timer() = default;
  /// Of wall time.
  explicit Timer(const ros::SteadyTimer& timer) : steady_(timer) {}
  /// Of the lab's time, as long as LockStep finds it alive.
  explicit Timer(std::shared_ptr<LockStep::Callback> timer) : lock_step_(std::move(timer)) {}

 private:
  ros::SteadyTimer steady_;
  std::shared_ptr<LockStep::Callback> lock_step_;
};

/// Time for watchdogs and control: steady, never ROS time, so that neither a paused simulation nor
/// a clock that is set stops them. In simulation it runs `speed` times faster than the wall, so
/// that limits keep their meaning; in lock step it is the lab's own time, which waits for everybody
/// who has to act in it.
///
/// Timers and messages that decide something come by it: in lock step they wait for their tick.
class SteadyClock {
 public:
  /// @param speed  simulated seconds per second, > 0; 1 on real robots
  explicit SteadyClock(double speed = 1.0);

  /// From the parameters kSpeedParameter and kLockStepParameter; without them, as on real robots, 1
  /// and not in lock step.
  /// @param suite_nh  in the suite's namespace
  /// @throws std::runtime_error if one is of the wrong type, or the speed not positive
  static SteadyClock fromParameter(const ros::NodeHandle& suite_nh,
                                   LockStep::Stage stage = LockStep::Stage::Second);
  /// For a node that only looks on, and for which nobody waits: in lock step this is ROS time.
  /// @throws std::runtime_error as fromParameter()
  static SteadyClock ofSpectator(const ros::NodeHandle& suite_nh);

  /// Seconds since some fixed moment, in simulated seconds.
  double now() const;
  /// ROS time of what happens now, for messages.
  ros::Time stamp() const { return lock_step_ ? lock_step_->stamp() : ros::Time::now(); }

  /// How long the wall takes for `simulated_s` seconds, for timers.
  ros::WallDuration wall(double simulated_s) const {
    return ros::WallDuration(simulated_s / speed_);
  }

  /// Simulated seconds in which something that takes a second of the wall may be waited for.
  double speed() const { return speed_; }

  /// Calls it each `period_s` of this clock.
  Timer createTimer(const ros::NodeHandle& nh, double period_s, LockStep::Callback callback) const;

  /// As ros::NodeHandle::advertise(), for messages that others act on.
  template <typename Message>
  Publisher advertise(ros::NodeHandle nh, const std::string& topic, std::uint32_t queue_size,
                      bool is_latched = false) const {
    return Publisher(nh.advertise<Message>(topic, queue_size, is_latched), lock_step_);
  }

  /// As ros::NodeHandle::subscribe(); in lock step `queue_size` and `hints` are not used, since
  /// nothing is dropped.
  template <typename Message>
  ros::Subscriber subscribe(ros::NodeHandle nh, const std::string& topic, std::uint32_t queue_size,
                            std::function<void(const Message&)> callback,
                            ros::TransportHints hints = ros::TransportHints().tcpNoDelay()) const {
    using Pointer = boost::shared_ptr<Message const>;
    boost::function<void(const Pointer&)> handle = [callback](const Pointer& message) {
      callback(*message);
    };
    if (lock_step_) {
      // Nothing is dropped: the box decides what is handled when.
      queue_size = 0;
      hints = ros::TransportHints().tcpNoDelay();
      handle = [callback, box = lock_step_->open(nh.resolveName(topic)),
                lock_step = lock_step_.get()](const Pointer& message) {
        box->push([callback, message] { callback(*message); });
        lock_step->onArrival();
      };
    }
    return nh.subscribe<Message>(topic, queue_size, handle, ros::VoidConstPtr(), hints);
  }

  /// Null unless the node is in lock step.
  const std::shared_ptr<LockStep>& lockStep() const { return lock_step_; }

 private:
  double speed_;
  bool follows_ros_time_ = false;
  std::shared_ptr<LockStep> lock_step_;
};

}  // namespace sylph_ros
