#include "sylph_adg_central/conversions.hpp"

#include <gtest/gtest.h>

#include "sylph_ros/conversions.hpp"

namespace sylph_adg_central {
namespace {

TEST(ConversionsTest, AViewTellsWhyARobotWaits) {
  sylph::RobotView view;
  view.task = sylph::Task();
  view.task->id = 3;
  view.task->end = {4, 5};
  view.cell = {4, 4};
  view.tasks_total = 2;
  view.waits_for_robot = "robot_1";
  view.waits_for_cell = {4, 5};
  view.waited_s = 2.5;
  view.root_cause_robot = "robot_2";
  view.root_cause = "no report for 3.0 s";
  const sylph_msgs::RobotExecution message = toMessage(view, "robot_0");
  EXPECT_EQ("robot_0", message.robot_id);
  EXPECT_TRUE(message.waiting);
  EXPECT_EQ("robot_1", message.waits_for_robot);
  EXPECT_EQ(2.5, message.waited_s);
  EXPECT_EQ("robot_2", message.root_cause_robot);
  EXPECT_EQ((sylph::Cell{4, 5}), sylph_ros::fromMessage(message.next_cell));
  view.task.reset();
  EXPECT_EQ((sylph::Cell{4, 4}), sylph_ros::fromMessage(toMessage(view, "robot_0").next_cell));
}

}  // namespace
}  // namespace sylph_adg_central
