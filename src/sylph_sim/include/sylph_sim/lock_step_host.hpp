#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <sylph_msgs/LockStepDone.h>
#include <sylph_msgs/LockStepTick.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sylph_ros/mailbox.hpp"
#include "sylph_sim/lock_step_members.hpp"

namespace sylph_sim {

/// How the simulator waits for the lab's nodes.
struct LockStepOptions {
  double period_s = 0.01;        ///< of lab time, between two ticks
  double clock_period_s = 0.05;  ///< the same between two messages on /clock
  double silent_after_s = 2.0;   ///< wall time without an answer, after which a node is silent
  double start_limit_s = 60.0;   ///< wall time that the lab waits for nodes before it begins
};

/// The simulator's part in lock step, see LockStepTick.msg: lets lab time go on by one tick when
/// all nodes have acted on the one before, the cameras' bridge first, then everybody else.
class LockStepHost {
 public:
  /// Lets the lab go on by one tick: to which moment, and the number of the cameras' last frame.
  struct Moment {
    ros::Time now;
    std::int32_t frame = 0;
  };
  using Advance = std::function<Moment()>;

  /// @param expected  full names of nodes without which the lab does not begin
  /// @param speed     ceiling, simulated seconds a wall second; 0: none
  LockStepHost(ros::NodeHandle suite_nh, const LockStepOptions& options,
               std::vector<std::string> expected, double speed, const ros::Time& start,
               Advance advance);

  /// Takes messages on a topic that count when the next tick begins.
  std::shared_ptr<sylph_ros::Mailbox::Box> open(const std::string& topic);
  /// Is to be told of each message that nodes in lock step are to have before the next tick.
  /// @param topic  full name
  void countMessage(const std::string& topic);
  /// A message has been put into a box.
  void onArrival() { proceed(); }

  bool hasBegun() const { return number_ > 0; }
  /// Simulated seconds a wall second, over the last full second of the wall.
  double speed() const { return measured_speed_; }
  /// Nodes that do not answer.
  std::vector<std::string> silent() const { return members_.silent(); }

 private:
  enum class Waiting { ForStart, ForTurn, ForFirst, ForSecond };

  ros::Publisher advertise(ros::NodeHandle& nh, const char* topic);
  void onDone(const sylph_msgs::LockStepDone& done);
  void onTimer();
  void callMembers(double wall_s);
  void proceed();
  void beginTick(double wall_s);
  void callSecond(double wall_s);
  void endTick();
  void addCounts(sylph_msgs::LockStepTick& tick, bool all);
  void measure(double wall_s);

  LockStepOptions options_;
  LockStepMembers members_;
  double speed_;
  Advance advance_;
  sylph_ros::Mailbox mailbox_;
  std::set<std::string> own_topics_;
  std::map<std::string, std::uint32_t> totals_;
  std::set<std::string> changed_;

  Waiting waiting_ = Waiting::ForStart;
  std::uint32_t number_ = 0;
  sylph_msgs::LockStepTick tick_;
  bool has_joined_ = false;     ///< a member, which needs all counts
  double began_wall_s_ = 0.0;   ///< waiting for the start
  double ready_since_s_ = 0.0;  ///< all are ready; 0: not all
  double told_wall_s_ = 0.0;
  double called_wall_s_ = 0.0;  ///< for the last time
  double asked_wall_s_ = 0.0;   ///< for the first time in this tick's second stage
  double next_wall_s_ = 0.0;
  double window_wall_s_ = 0.0;
  std::uint32_t window_number_ = 0;
  double measured_speed_ = 0.0;

  ros::Publisher first_publisher_;
  ros::Publisher second_publisher_;
  ros::Subscriber done_subscriber_;
  ros::SteadyTimer timer_;
};

}  // namespace sylph_sim
