#include "sylph_sim/lock_step_host.hpp"

#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/this_node.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"

/// The simulator's part; the test is the nodes.
namespace sylph_sim {
namespace {

constexpr char kTopic[] = "/sylph/robot_0/cmd_vel";

class LockStepHostTest : public testing::Test {
 protected:
  LockStepHostTest() {
    options_.silent_after_s = 0.5;
    ticks_ = nh_.subscribe<sylph_msgs::LockStepTick>(
        sylph_ros::kLockStepSecondTopic, 100,
        [this](const sylph_msgs::LockStepTick::ConstPtr& tick) { answer(tick->number); });
  }

  /// What a node does that acts in the first half of a tick.
  void startFirst() {
    first_ticks_ = nh_.subscribe<sylph_msgs::LockStepTick>(
        sylph_ros::kLockStepFirstTopic, 100,
        [this](const sylph_msgs::LockStepTick::ConstPtr& tick) {
          ++first_answers_;
          sylph_msgs::LockStepDone done;
          done.node = ros::this_node::getName();
          done.stage = sylph_msgs::LockStepDone::FIRST;
          done.number = tick->number;
          done.is_ready = 1;
          answers_.publish(done);
        });
  }

  void answer(std::uint32_t number) {
    for (const std::string& node : nodes_) {
      if (node != "/lively" && number >= silent_from_) {
        continue;
      }
      sylph_msgs::LockStepDone done;
      done.node = node;
      done.stage = sylph_msgs::LockStepDone::SECOND;
      done.number = number;
      done.is_ready = 1;
      if (number == 3) {
        done.topics = {kTopic};
        done.counts = {announced_};
      }
      answers_.publish(done);
    }
  }

  /// @return whether the lab comes so far before 20 s of wall time have passed
  bool reaches(int tick) const {
    return sylph_ros::waitUntil(
        [this, tick] { return advanced_ >= tick; },
        [] { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.002)); });
  }

  LockStepHost::Moment advance() {
    ++advanced_;
    return {ros::Time(100.0 + 0.01 * advanced_), 0};
  }

  ros::NodeHandle nh_{"/sylph"};
  std::vector<std::string> nodes_{"/lively", "/silent"};
  std::uint32_t silent_from_ = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t announced_ = 0;
  int advanced_ = 0;
  int first_answers_ = 0;
  LockStepOptions options_;
  ros::Publisher answers_ =
      nh_.advertise<sylph_msgs::LockStepDone>(sylph_ros::kLockStepDoneTopic, 100);
  ros::Publisher commands_ = nh_.advertise<geometry_msgs::Twist>(kTopic, 100);
  ros::Subscriber ticks_;
  ros::Subscriber first_ticks_;
};

TEST_F(LockStepHostTest, WaitsForEachNodeButNotForEver) {
  silent_from_ = 5;
  LockStepHost host(nh_, options_, nodes_, 0.0, ros::Time(100.0), [this] { return advance(); });
  ASSERT_TRUE(reaches(5));
  EXPECT_TRUE(host.silent().empty());
  ASSERT_TRUE(reaches(100));
  EXPECT_EQ(std::vector<std::string>{"/silent"}, host.silent());
}

TEST_F(LockStepHostTest, DoesNotWaitForANodeThatHasEnded) {
  options_.silent_after_s = 1e3;
  nodes_ = {ros::this_node::getName()};
  silent_from_ = 5;
  LockStepHost host(nh_, options_, nodes_, 0.0, ros::Time(100.0), [this] { return advance(); });
  ASSERT_TRUE(reaches(5));
  ticks_.shutdown();
  ASSERT_TRUE(reaches(100));
  EXPECT_TRUE(host.silent().empty());
}

// As the bridge to motion capture, the only such node of a lab, which roslaunch starts again.
TEST_F(LockStepHostTest, TheOnlyFirstNodeIsAMemberAgainAfterItHasEnded) {
  options_.silent_after_s = 1e3;
  startFirst();
  LockStepHost host(nh_, options_, nodes_, 0.0, ros::Time(100.0), [this] { return advance(); });
  ASSERT_TRUE(reaches(5));
  first_ticks_.shutdown();
  ASSERT_TRUE(reaches(advanced_ + 100));
  const int before_end = first_answers_;
  startFirst();
  EXPECT_TRUE(sylph_ros::waitUntil(
      [&] { return first_answers_ >= before_end + 10; },
      [] { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.002)); }));
  EXPECT_TRUE(reaches(advanced_ + 100));
  EXPECT_TRUE(host.silent().empty());
}

TEST_F(LockStepHostTest, ACommandThatIsLostIsNotWaitedForForEver) {
  announced_ = 1;
  LockStepHost host(nh_, options_, nodes_, 0.0, ros::Time(100.0), [this] { return advance(); });
  const auto box = host.open(kTopic);
  const boost::function<void(const geometry_msgs::TwistConstPtr&)> take =
      [&](const geometry_msgs::TwistConstPtr&) { box->push([] {}); };
  const ros::Subscriber subscriber = nh_.subscribe<geometry_msgs::Twist>(kTopic, 0, take);
  EXPECT_TRUE(reaches(100));
  EXPECT_TRUE(host.silent().empty());
}

}  // namespace
}  // namespace sylph_sim

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "lock_step_host_test");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
