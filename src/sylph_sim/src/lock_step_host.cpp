#include "sylph_sim/lock_step_host.hpp"

#include <ros/console.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/topic_manager.h>
#include <ros/transport_hints.h>

#include <algorithm>
#include <utility>

#include "sylph_core/text/join.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_sim {
namespace {

constexpr double kTimerPeriodWall_s = 0.002;
/// Nodes are asked again so often, until the lab begins and when they do not answer [wall s].
constexpr double kCallPeriodWall_s = 0.1;
/// A connection that one end has made becomes known to the other end meanwhile [wall s].
constexpr double kSettleWall_s = 0.3;
/// A command that was announced and does not come for so long has been lost [wall s].
constexpr double kPatienceWall_s = 0.5;
/// After a hitch the lab catches up with at most so much [wall s].
constexpr double kMaxBacklogWall_s = 0.1;
constexpr std::uint32_t kQueue = 1000;

double wallNow() {
  return ros::SteadyTime::now().toSec();
}

bool hasPublisher(const std::string& topic) {
  return ros::TopicManager::instance()->getNumPublishers(topic) > 0;
}

}  // namespace

LockStepHost::LockStepHost(ros::NodeHandle suite_nh, const LockStepOptions& options,
                           std::vector<std::string> expected, double speed, const ros::Time& start,
                           Advance advance)
    : options_(options),
      members_(std::move(expected), options.silent_after_s),
      speed_(speed),
      advance_(std::move(advance)),
      began_wall_s_(wallNow()),
      told_wall_s_(wallNow()) {
  tick_.start = start;
  tick_.now = start;
  first_publisher_ = advertise(suite_nh, sylph_ros::kLockStepFirstTopic);
  second_publisher_ = advertise(suite_nh, sylph_ros::kLockStepSecondTopic);
  done_subscriber_ = suite_nh.subscribe<sylph_msgs::LockStepDone>(
      sylph_ros::kLockStepDoneTopic, kQueue,
      [this](const sylph_msgs::LockStepDone::ConstPtr& message) { onDone(*message); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  timer_ = suite_nh.createSteadyTimer(ros::WallDuration(kTimerPeriodWall_s),
                                      [this](const ros::SteadyTimerEvent&) { onTimer(); });
}

ros::Publisher LockStepHost::advertise(ros::NodeHandle& nh, const char* topic) {
  return nh.advertise<sylph_msgs::LockStepTick>(topic, kQueue, ros::SubscriberStatusCallback(),
                                                [this](const ros::SingleSubscriberPublisher& node) {
                                                  // Its process has ended: that is heard at once,
                                                  // and the lab is none that waits for it.
                                                  members_.leave(node.getSubscriberName());
                                                  proceed();
                                                });
}

std::shared_ptr<sylph_ros::Mailbox::Box> LockStepHost::open(const std::string& topic) {
  own_topics_.insert(topic);
  return mailbox_.open(topic);
}

void LockStepHost::countMessage(const std::string& topic) {
  ++totals_[topic];
  changed_.insert(topic);
}

void LockStepHost::onDone(const sylph_msgs::LockStepDone& done) {
  if (done.stage > sylph_msgs::LockStepDone::START_ONLY ||
      done.topics.size() != done.counts.size()) {
    ROS_WARN_THROTTLE(1.0, "malformed answer of %s in lock step", done.node.c_str());
    return;
  }
  for (std::size_t i = 0; i < done.topics.size(); ++i) {
    std::uint32_t& total = totals_[done.topics[i]];
    if (total != done.counts[i]) {
      total = done.counts[i];
      if (own_topics_.count(done.topics[i]) > 0) {
        mailbox_.announce(done.topics[i], total);
      } else {
        changed_.insert(done.topics[i]);
      }
    }
  }
  const LockStepMembers::Return back =
      members_.note({done.node, static_cast<LockStepMembers::Stage>(done.stage), done.number,
                     done.is_ready != 0, done.is_busy != 0},
                    wallNow());
  has_joined_ = has_joined_ || back.is_new;
  if (back.silent_s > 0.0) {
    ROS_WARN("%s answers again after %.1f s", done.node.c_str(), back.silent_s);
  }
  proceed();
}

void LockStepHost::onTimer() {
  const double wall_s = wallNow();
  measure(wall_s);
  if (waiting_ == Waiting::ForStart) {
    callMembers(wall_s);
    return;
  }
  if (waiting_ == Waiting::ForFirst || waiting_ == Waiting::ForSecond) {
    for (const std::string& name : members_.findSilent(wall_s)) {
      ROS_WARN("%s has not answered for %.1f s: the lab goes on without it", name.c_str(),
               options_.silent_after_s);
    }
    if (wall_s - called_wall_s_ > kCallPeriodWall_s) {
      called_wall_s_ = wall_s;
      // Said again as long as a node has not answered: a message may be lost.
      (waiting_ == Waiting::ForFirst ? first_publisher_ : second_publisher_).publish(tick_);
    }
  }
  proceed();
}

void LockStepHost::callMembers(double wall_s) {
  if (wall_s - called_wall_s_ > kCallPeriodWall_s) {
    called_wall_s_ = wall_s;
    addCounts(tick_, true);
    first_publisher_.publish(tick_);
    second_publisher_.publish(tick_);
  }
  const std::vector<std::string> unready = members_.unready();
  if (!unready.empty()) {
    ready_since_s_ = 0.0;
  } else if (ready_since_s_ == 0.0) {
    ready_since_s_ = wall_s;
  }
  const bool is_late = wall_s - began_wall_s_ > options_.start_limit_s;
  if (!unready.empty() && is_late) {
    ROS_WARN("the lab begins without %s", sylph::join(unready).c_str());
  } else if (ready_since_s_ == 0.0 || wall_s - ready_since_s_ < kSettleWall_s) {
    return;
  }
  mailbox_.forgive();
  next_wall_s_ = wall_s;
  waiting_ = Waiting::ForTurn;
}

void LockStepHost::proceed() {
  const double wall_s = wallNow();
  if (waiting_ == Waiting::ForFirst && members_.hasAnswered()) {
    callSecond(wall_s);
  }
  if (waiting_ == Waiting::ForSecond && members_.hasAnswered() &&
      (mailbox_.isComplete(hasPublisher) || wall_s - asked_wall_s_ > kPatienceWall_s)) {
    endTick();
  }
  if (waiting_ == Waiting::ForTurn && (speed_ <= 0.0 || wall_s >= next_wall_s_)) {
    beginTick(wall_s);
  }
}

void LockStepHost::beginTick(double wall_s) {
  if (speed_ > 0.0) {
    // A lab that was held up does not race afterwards to make up for it.
    next_wall_s_ = std::max(next_wall_s_ + options_.period_s / speed_, wall_s - kMaxBacklogWall_s);
  }
  const Moment moment = advance_();
  tick_.number = ++number_;
  tick_.now = moment.now;
  tick_.frame = moment.frame;
  tick_.has_all_counts = 0;
  tick_.topics.clear();
  tick_.counts.clear();
  waiting_ = Waiting::ForFirst;
  called_wall_s_ = wall_s;
  members_.call(LockStepMembers::Stage::First, number_, wall_s);
  // To no members too: a node that is started again becomes one by answering.
  first_publisher_.publish(tick_);
  if (members_.hasAnswered()) {
    callSecond(wall_s);
  }
}

void LockStepHost::callSecond(double wall_s) {
  // Counts of what has changed; all of them where a member is new and knows none.
  addCounts(tick_, std::exchange(has_joined_, false));
  waiting_ = Waiting::ForSecond;
  called_wall_s_ = asked_wall_s_ = wall_s;
  members_.call(LockStepMembers::Stage::Second, number_, wall_s);
  second_publisher_.publish(tick_);
}

void LockStepHost::endTick() {
  mailbox_.deliver();
  mailbox_.endStep();
  waiting_ = Waiting::ForTurn;
}

void LockStepHost::addCounts(sylph_msgs::LockStepTick& tick, bool all) {
  tick.has_all_counts = static_cast<std::uint8_t>(all);
  tick.topics.clear();
  tick.counts.clear();
  for (const auto& [topic, total] : totals_) {
    if ((all && own_topics_.count(topic) == 0) || changed_.count(topic) > 0) {
      tick.topics.push_back(topic);
      tick.counts.push_back(total);
    }
  }
  changed_.clear();
}

void LockStepHost::measure(double wall_s) {
  const double elapsed_s = wall_s - window_wall_s_;
  if (elapsed_s >= 1.0) {
    measured_speed_ = (number_ - window_number_) * options_.period_s / elapsed_s;
    window_wall_s_ = wall_s;
    window_number_ = number_;
  }
}

}  // namespace sylph_sim
