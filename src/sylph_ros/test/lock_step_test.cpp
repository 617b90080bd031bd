#include "sylph_ros/lock_step.hpp"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/init.h>
#include <std_msgs/Empty.h>

#include <functional>
#include <optional>

#include "sylph_ros/steady_clock.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"

/// One node in lock step; the test is the simulator, and says ticks again as the simulator does.
namespace sylph_ros {
namespace {

constexpr char kTopic[] = "/sylph/news";

class LockStepTest : public testing::Test {
 protected:
  LockStepTest() {
    nh_.setParam(kLockStepParameter, true);
    clock_.emplace(SteadyClock::fromParameter(nh_));
    listener_ = clock_->subscribe<std_msgs::Empty>(nh_, kTopic, 10,
                                                   [this](const std_msgs::Empty&) { ++heard_; });
    tick_.start = ros::Time(100.0);
    tick_.now = tick_.start;
    EXPECT_TRUE(sayUntil([this] { return done_ && done_->number == 0 && done_->is_ready; }));
  }

  /// @return whether the condition holds before 20 s of wall time have passed
  bool sayUntil(const std::function<bool()>& condition) {
    return waitUntil(condition, [this] {
      ticks_.publish(tick_);
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
    });
  }

  void nextTick(std::uint32_t announced) {
    ++tick_.number;
    tick_.now += ros::Duration(0.01);
    tick_.has_all_counts = tick_.number == 1 ? 1 : 0;
    tick_.topics = {kTopic};
    tick_.counts = {announced};
  }

  bool isDone() const { return done_ && done_->number == tick_.number && done_->is_busy == 0; }

  ros::NodeHandle nh_{"/sylph"};
  ros::Publisher ticks_ = nh_.advertise<sylph_msgs::LockStepTick>(kLockStepSecondTopic, 10);
  ros::Publisher news_ = nh_.advertise<std_msgs::Empty>(kTopic, 10);
  std::optional<sylph_msgs::LockStepDone> done_;
  ros::Subscriber answers_ = nh_.subscribe<sylph_msgs::LockStepDone>(
      kLockStepDoneTopic, 10,
      [this](const sylph_msgs::LockStepDone::ConstPtr& message) { done_ = *message; });
  std::optional<SteadyClock> clock_;
  ros::Subscriber listener_;
  sylph_msgs::LockStepTick tick_;
  int heard_ = 0;
};

TEST_F(LockStepTest, ActsWhenWhatWasAnnouncedHasCome) {
  nextTick(0);
  ASSERT_TRUE(sayUntil([this] { return isDone(); }));
  news_.publish(std_msgs::Empty());
  nextTick(1);
  ASSERT_TRUE(sayUntil([this] { return isDone(); }));
  EXPECT_EQ(1, heard_);
  EXPECT_EQ(tick_.now, clock_->stamp());
}

TEST_F(LockStepTest, AMessageThatIsLostIsNotWaitedForForEver) {
  nextTick(0);
  ASSERT_TRUE(sayUntil([this] { return isDone(); }));
  nextTick(1);
  EXPECT_TRUE(sayUntil([this] { return isDone(); }));
  EXPECT_EQ(0, heard_);
  EXPECT_EQ(tick_.now, clock_->stamp());
}

}  // namespace
}  // namespace sylph_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "lock_step_test");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
