#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <ros/time.h>
#include <sylph_msgs/LockStepDone.h>
#include <sylph_msgs/LockStepTick.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sylph_ros/mailbox.hpp"

namespace sylph_ros {

/// One node's part in the lock step of a simulated lab, see LockStepTick.msg: what it is told waits
/// until the simulator announces it, its timers go by the lab's time, and the lab's time does not
/// go on before it has acted.
///
/// Everything happens in the thread that spins.
class LockStep {
 public:
  /// When in a tick the node acts, see LockStepDone.msg.
  enum class Stage : std::uint8_t {
    First = sylph_msgs::LockStepDone::FIRST,
    Second = sylph_msgs::LockStepDone::SECOND,
    StartOnly = sylph_msgs::LockStepDone::START_ONLY,
  };
  /// What a timer does when it is due.
  using Callback = std::function<void()>;

  /// @param suite_nh  in the suite's namespace
  LockStep(const ros::NodeHandle& suite_nh, Stage stage);
  LockStep(const LockStep&) = delete;
  LockStep& operator=(const LockStep&) = delete;

  /// Lab time since it began, and then some, so that it is never 0 [s].
  double now() const;
  /// Lab time as it stands in messages.
  ros::Time stamp() const { return now_; }

  /// @param topic  full name
  /// @return takes the topic's messages; as long as the caller holds it, they are waited for
  std::shared_ptr<Mailbox::Box> open(const std::string& topic);
  /// Is to be told of each message before it is published.
  /// @param topic  full name
  void countMessage(const std::string& topic);
  /// Calls it each period of lab time, as long as the caller holds the result.
  std::shared_ptr<Callback> addTimer(double period_s, Callback callback);

  /// Is called first in each tick, with the number of the cameras' last frame.
  void setFrameSource(std::function<void(std::int32_t frame)> source) {
    take_frames_ = std::move(source);
  }
  /// The lab does not begin before this.
  void requireAtStart(std::function<bool()> is_ready) { is_ready_ = std::move(is_ready); }
  /// The present tick does not end before this.
  void holdUntil(std::function<bool()> is_done) { is_held_until_ = std::move(is_done); }

  /// Hands over a message that has come. Tries to act.
  void onArrival();
  /// For how long no tick has come [wall s].
  double silence() const;

 private:
  struct Timer {
    std::weak_ptr<Callback> callback;
    ros::Duration period;
    ros::Time next;  ///< zero: not known before the lab has begun
  };

  void onTick(const sylph_msgs::LockStepTick& tick);
  void announce(const sylph_msgs::LockStepTick& tick);
  void onWallTimer();
  void act();
  void runTimers();
  void end();
  void answer(std::uint32_t number, bool is_busy);
  bool isReady() const;

  std::string name_;
  Stage stage_;
  Mailbox mailbox_;
  std::vector<Timer> timers_;
  std::map<std::string, std::uint32_t> totals_;  ///< published by this node, by topic
  std::set<std::string> changed_;                ///< of those, since the last answer
  std::set<std::string> subscribed_;

  ros::Time start_;
  ros::Time now_;
  ros::SteadyTime heard_;  ///< of the last tick
  std::optional<sylph_msgs::LockStepTick> pending_;
  bool is_in_step_ = false;  ///< knows how many messages there are, and has missed no tick
  bool takes_all_ = false;   ///< whatever has come, in the pending tick
  ros::SteadyTime pending_since_;
  bool has_acted_ = false;  ///< on the pending one, and is held
  std::uint32_t done_ = 0;  ///< number of the last tick acted upon
  sylph_msgs::LockStepDone last_answer_;

  std::function<void(std::int32_t)> take_frames_;
  std::function<bool()> is_ready_;
  std::function<bool()> is_held_until_;
  ros::Publisher done_publisher_;
  ros::Subscriber tick_subscriber_;
  ros::SteadyTimer wall_timer_;
};

}  // namespace sylph_ros
