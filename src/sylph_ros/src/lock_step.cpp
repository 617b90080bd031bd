#include "sylph_ros/lock_step.hpp"

#include <ros/console.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/transport_hints.h>

#include <algorithm>
#include <utility>

#include "sylph_ros/topics.hpp"

namespace sylph_ros {
namespace {

/// A clock that shows 0 is one that has not been set.
constexpr double kOrigin_s = 1000.0;
/// A message that was announced and does not come for so long has been lost [wall s].
constexpr double kPatience_s = 0.5;
constexpr double kWallPeriod_s = 0.05;
constexpr std::uint32_t kQueue = 10;

bool hasPublisher(const std::string& topic) {
  return ros::TopicManager::instance()->getNumPublishers(topic) > 0;
}

}  // namespace

LockStep::LockStep(const ros::NodeHandle& suite_nh, Stage stage)
    : name_(ros::this_node::getName()), stage_(stage), heard_(ros::SteadyTime::now()) {
  ros::NodeHandle nh = suite_nh;
  done_publisher_ = nh.advertise<sylph_msgs::LockStepDone>(kLockStepDoneTopic, kQueue);
  const char* topic = stage == Stage::First ? kLockStepFirstTopic : kLockStepSecondTopic;
  tick_subscriber_ = nh.subscribe<sylph_msgs::LockStepTick>(
      topic, kQueue,
      [this](const sylph_msgs::LockStepTick::ConstPtr& message) { onTick(*message); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  wall_timer_ = nh.createSteadyTimer(ros::WallDuration(kWallPeriod_s),
                                     [this](const ros::SteadyTimerEvent&) { onWallTimer(); });
}

double LockStep::now() const {
  return kOrigin_s + (now_ - start_).toSec();
}

double LockStep::silence() const {
  return (ros::SteadyTime::now() - heard_).toSec();
}

std::shared_ptr<Mailbox::Box> LockStep::open(const std::string& topic) {
  subscribed_.insert(topic);
  return mailbox_.open(topic);
}

void LockStep::countMessage(const std::string& topic) {
  ++totals_[topic];
  changed_.insert(topic);
}

std::shared_ptr<LockStep::Callback> LockStep::addTimer(double period_s, Callback callback) {
  auto held = std::make_shared<Callback>(std::move(callback));
  const ros::Duration period(period_s);
  timers_.push_back({held, period, done_ > 0 ? now_ + period : ros::Time()});
  return held;
}

void LockStep::onTick(const sylph_msgs::LockStepTick& tick) {
  heard_ = ros::SteadyTime::now();
  if (stage_ == Stage::StartOnly && tick.number > 0) {
    tick_subscriber_.shutdown();
    wall_timer_.stop();
  } else if (tick.number == 0) {
    start_ = tick.start;
    now_ = tick.now;
    announce(tick);
    answer(0, false);
  } else if (tick.number == done_ && !pending_) {
    done_publisher_.publish(last_answer_);  // the last one was missed
  } else if (!(pending_ && pending_->number == tick.number)) {
    // Who has missed a tick takes what has come and waits for nothing, until told all counts.
    is_in_step_ = is_in_step_ && !pending_ && tick.number == done_ + 1;
    announce(tick);
    has_acted_ = false;
    pending_ = tick;
    pending_since_ = heard_;
    onArrival();
  }
}

void LockStep::announce(const sylph_msgs::LockStepTick& tick) {
  for (std::size_t i = 0; i < std::min(tick.topics.size(), tick.counts.size()); ++i) {
    mailbox_.announce(tick.topics[i], tick.counts[i]);
  }
  if (tick.number == 0 || !is_in_step_) {
    mailbox_.forgive();
    is_in_step_ = is_in_step_ || tick.has_all_counts != 0;
    takes_all_ = tick.number != 0;
  }
}

void LockStep::onArrival() {
  if (pending_ && !has_acted_ && (takes_all_ || mailbox_.isComplete(hasPublisher))) {
    act();
  }
}

void LockStep::onWallTimer() {
  if (pending_ && !has_acted_) {
    onArrival();  // whose publisher is gone need not be waited for
  }
  if (!pending_) {
    return;
  }
  if (!has_acted_) {
    // Not since the last tick: it is said again as long as there is no answer.
    if ((ros::SteadyTime::now() - pending_since_).toSec() > kPatience_s) {
      ROS_DEBUG("lock step: a message was lost before tick %u", pending_->number);
      act();
    }
  } else if (!is_held_until_ || is_held_until_()) {
    end();
  } else {
    answer(pending_->number, true);
  }
}

void LockStep::act() {
  has_acted_ = true;
  start_ = pending_->start;
  now_ = pending_->now;
  if (std::exchange(takes_all_, false)) {
    mailbox_.endStep();  // all that has come meanwhile is left over
  }
  if (take_frames_) {
    take_frames_(pending_->frame);
  }
  mailbox_.deliver();
  runTimers();
  if (!is_held_until_ || is_held_until_()) {
    end();
  }
}

void LockStep::runTimers() {
  timers_.erase(std::remove_if(timers_.begin(), timers_.end(),
                               [](const Timer& timer) { return timer.callback.expired(); }),
                timers_.end());
  // NOLINTNEXTLINE(modernize-loop-convert): a timer may make timers.
  for (std::size_t i = 0; i < timers_.size(); ++i) {
    if (timers_[i].next.isZero()) {
      timers_[i].next = start_ + timers_[i].period;
    }
    if (now_ < timers_[i].next) {
      continue;
    }
    // No calls to catch up with after a long step: one is enough.
    timers_[i].next = std::max(timers_[i].next + timers_[i].period, now_);
    if (const auto callback = timers_[i].callback.lock()) {
      (*callback)();
    }
  }
}

void LockStep::end() {
  is_held_until_ = nullptr;
  mailbox_.endStep();
  done_ = pending_->number;
  pending_.reset();
  answer(done_, false);
}

void LockStep::answer(std::uint32_t number, bool is_busy) {
  sylph_msgs::LockStepDone done;
  done.node = name_;
  done.stage = static_cast<std::uint8_t>(stage_);
  done.number = number;
  done.is_busy = static_cast<std::uint8_t>(is_busy);
  if (number == 0) {
    done.is_ready = static_cast<std::uint8_t>(isReady());
  }
  if (!is_busy) {
    for (const std::string& topic : changed_) {
      done.topics.push_back(topic);
      done.counts.push_back(totals_[topic]);
    }
    changed_.clear();
    last_answer_ = done;
  }
  done_publisher_.publish(done);
}

bool LockStep::isReady() const {
  return std::all_of(subscribed_.begin(), subscribed_.end(), hasPublisher) &&
         (!is_ready_ || is_ready_());
}

}  // namespace sylph_ros
