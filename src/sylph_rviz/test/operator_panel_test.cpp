#include "sylph_rviz/operator_panel.hpp"

#include <actionlib/server/simple_action_server.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>
#include <sylph_msgs/ReplayExtent.h>

#include <QApplication>
#include <QColor>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QThread>
#include <atomic>
#include <functional>
#include <future>
#include <vector>

#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"
#include "sylph_rviz/palette.hpp"
#include "sylph_rviz/svo_chart.hpp"
#include "test_scene.hpp"

namespace sylph_rviz {
namespace {

/// The panel, without RViz around it, and mocks of the nodes that it talks with.
class OperatorPanelTest : public ::testing::Test {
 protected:
  using Server = actionlib::SimpleActionServer<sylph_msgs::ExecuteMissionAction>;

  OperatorPanelTest()
      : suite_("sylph"),
        states_(suite_.advertise<sylph_msgs::AdgState>(sylph_ros::kAdgStateTopic, 1)),
        state_(*twoRobots().state) {}

  /// A central node whose pause service begins with what `on_pause` does.
  void startCentral(const std::function<void()>& on_pause) {
    pause_ = suite_.advertiseService<std_srvs::TriggerRequest, std_srvs::TriggerResponse>(
        sylph_ros::kPauseService,
        [on_pause](std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response) {
          on_pause();
          response.success = 1;
          return true;
        });
  }

  /// Until then states are sent and the panel is served as RViz does it.
  bool waitUntil(const std::function<bool()>& condition) {
    return sylph_ros::waitUntil(condition, [this] {
      states_.publish(state_);
      QApplication::processEvents();
      QThread::msleep(20);
    });
  }

  QPushButton& button(const char* name) { return *panel_.findChild<QPushButton*>(name); }
  std::string label(const char* name) {
    return panel_.findChild<QLabel*>(name)->text().toStdString();
  }

  ros::NodeHandle suite_;
  ros::Publisher states_;
  sylph_msgs::AdgState state_;
  ros::ServiceServer pause_;
  OperatorPanel panel_;
};

TEST_F(OperatorPanelTest, ShowsARowForEachRobot) {
  auto& table = *panel_.findChild<QTableWidget*>("robots");
  ASSERT_TRUE(waitUntil([&] { return table.rowCount() == 2; }));
  EXPECT_EQ("robot_0", table.item(0, 0)->text().toStdString());
  EXPECT_EQ("drives", table.item(0, 1)->text().toStdString());
}

TEST_F(OperatorPanelTest, AButtonCallsItsServiceAndTellsHowThatEnded) {
  std::atomic<int> calls{0};
  startCentral([&calls] { ++calls; });
  ASSERT_TRUE(waitUntil([&] { return button("pause").isEnabled(); }));
  button("pause").click();
  ASSERT_TRUE(waitUntil([&] { return label("outcome") == "pause: done"; })) << label("outcome");
  EXPECT_EQ(1, calls);
}

TEST_F(OperatorPanelTest, GoesOnWhileAServiceDoesNotAnswer) {
  std::promise<void> end;
  const std::shared_future<void> may_answer = end.get_future().share();
  startCentral([may_answer] { may_answer.wait(); });
  ASSERT_TRUE(waitUntil([&] { return button("pause").isEnabled(); }));
  button("pause").click();
  state_.phase = sylph_msgs::AdgState::FINISHED;
  EXPECT_TRUE(waitUntil([&] { return label("headline") == "finished"; })) << label("headline");
  EXPECT_TRUE(waitUntil([&] { return label("outcome") == "pause: no answer for 2 s"; }))
      << label("outcome");
  end.set_value();
}

TEST_F(OperatorPanelTest, TellsWhatTheMotionCaptureOfItsFleetLacks) {
  startCentral([] {});  // without its services the panel takes it for a replay
  ros::Publisher publisher =
      ros::NodeHandle().advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1);
  diagnostic_msgs::DiagnosticArray diagnostics;
  diagnostics.status.resize(2);
  diagnostics.status[0].name = "other/sylph/mocap_bridge: link";
  diagnostics.status[0].level = diagnostic_msgs::DiagnosticStatus::ERROR;
  diagnostics.status[1] = diagnostics.status[0];
  diagnostics.status[1].name = "sylph/mocap_bridge: link";
  diagnostics.status[1].message = "no frame from 192.168.1.2";
  state_.phase = sylph_msgs::AdgState::IDLE;
  const auto placeOfStop = [&] {
    panel_.grab();  // lays it out
    return button("stop").mapTo(&panel_, QPoint()).y();
  };
  ASSERT_TRUE(waitUntil([&] { return label("message").empty(); })) << label("message");
  const int place = placeOfStop();
  EXPECT_TRUE(waitUntil([&] {
    publisher.publish(diagnostics);
    return label("message") == "sylph/mocap_bridge: link: no frame from 192.168.1.2";
  })) << label("message");
  EXPECT_EQ(place, placeOfStop()) << "STOP moves away from under the mouse";
}

TEST_F(OperatorPanelTest, TellsThatNobodyOffersAService) {
  ASSERT_TRUE(waitUntil([&] { return button("stop").isEnabled(); }));
  button("stop").click();
  EXPECT_TRUE(waitUntil([&] { return label("outcome") == "stop: nobody offers /sylph/stop"; }))
      << label("outcome");
}

TEST_F(OperatorPanelTest, StartsTheChosenExperimentWithTheChosenPlanner) {
  state_.phase = sylph_msgs::AdgState::IDLE;
  startCentral([] {});
  Server server(suite_, sylph_ros::kExecuteMissionAction, false);
  std::promise<sylph_msgs::ExecuteMissionGoal> goal;
  server.registerGoalCallback([&] { goal.set_value(*server.acceptNewGoal()); });
  server.start();
  ASSERT_TRUE(waitUntil([&] { return button("start").isEnabled(); }))
      << button("start").toolTip().toStdString();
  panel_.findChild<QComboBox*>("planner")->setCurrentText("pibt");
  button("start").click();
  auto received = goal.get_future();
  ASSERT_TRUE(waitUntil(
      [&] { return received.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }));
  const sylph_msgs::ExecuteMissionGoal mission = received.get();
  EXPECT_EQ("pibt", mission.planner);
  EXPECT_FALSE(mission.robots.empty());
  EXPECT_EQ(mission.robots.size(), mission.goals.size());
  ASSERT_TRUE(server.isActive());
  server.setSucceeded();
}

TEST_F(OperatorPanelTest, SelectsARobotByItsRowAndShowsWhatOthersSelect) {
  std::string selected;
  const ros::Subscriber listener = suite_.subscribe<std_msgs::String>(
      sylph_ros::kSelectedRobotTopic, 1,
      [&](const std_msgs::String::ConstPtr& robot) { selected = robot->data; });
  auto& table = *panel_.findChild<QTableWidget*>("robots");
  ASSERT_TRUE(waitUntil([&] { return table.rowCount() == 2; }));
  table.selectRow(1);
  EXPECT_TRUE(waitUntil([&] { return selected == "robot_1"; })) << selected;
  ros::Publisher other =
      suite_.advertise<std_msgs::String>(sylph_ros::kSelectedRobotTopic, 1, true);
  std_msgs::String robot;
  robot.data = "robot_0";
  other.publish(robot);
  EXPECT_TRUE(waitUntil([&] { return table.item(0, 0)->isSelected(); }));
  EXPECT_FALSE(table.item(1, 0)->isSelected());
  table.clearSelection();
  EXPECT_TRUE(waitUntil([&] { return selected.empty(); })) << selected;
}

TEST_F(OperatorPanelTest, ASecondPanelShowsWhatIsSelected) {
  auto& table = *panel_.findChild<QTableWidget*>("robots");
  ASSERT_TRUE(waitUntil([&] { return table.rowCount() == 2; }));
  table.selectRow(1);
  const OperatorPanel second;
  auto& second_table = *second.findChild<QTableWidget*>("robots");
  ASSERT_TRUE(waitUntil([&] { return second_table.rowCount() == 2; }));
  EXPECT_TRUE(waitUntil([&] { return second_table.item(1, 0)->isSelected(); }));
  EXPECT_TRUE(table.item(1, 0)->isSelected());
}

TEST_F(OperatorPanelTest, DrawsTheSvosOfTheSelectedRobotInItsPlan) {
  auto& chart = *panel_.findChild<SvoChart*>("svo");
  sylph::MissionPlan plan;
  plan.plan_id = state_.plan_id;
  plan.robots = {"robot_0", "robot_1"};
  plan.goals = {{1, 0}, {3, 4}};
  plan.plan = {{{3, 0}, {3, 4}}, {{2, 0}, {3, 4}}, {{1, 0}, {3, 4}}};
  plan.social = {{{1, 0}, {10.0F, 20.0F}}, {{1, 0}, {40.0F, 20.0F}}};
  ros::Publisher planner =
      suite_.advertise<sylph_msgs::JointActions>(sylph_ros::kJointActionsTopic, 1, true);
  planner.publish(sylph_ros::toMessage(plan));
  auto& table = *panel_.findChild<QTableWidget*>("robots");
  ASSERT_TRUE(waitUntil([&] { return table.rowCount() == 2; }));
  EXPECT_TRUE(chart.isHidden());
  table.selectRow(0);
  ASSERT_TRUE(waitUntil([&] { return !chart.isHidden(); }));
  const QImage image = chart.grab().toImage();
  const auto pixels = [&image](double svo_deg) {
    const std_msgs::ColorRGBA wanted = svoColor(svo_deg);
    const QRgb color = QColor::fromRgbF(wanted.r, wanted.g, wanted.b).rgb();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        count += image.pixel(x, y) == color ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_GT(pixels(10.0), 0);
  EXPECT_NEAR(4.0, static_cast<double>(pixels(40.0)) / pixels(10.0), 0.8)
      << "columns of equal width, as high as the SVO, under the lines";
}

TEST_F(OperatorPanelTest, ConfirmsThePoseOfTheSelectedRobotWhileAllAreStopped) {
  startCentral([] {});
  ros::NodeHandle robot("robot_1");
  std::atomic<int> calls{0};
  const ros::ServiceServer server =
      robot.advertiseService<std_srvs::TriggerRequest, std_srvs::TriggerResponse>(
          sylph_ros::kConfirmPoseService,
          [&calls](std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response) {
            ++calls;
            response.message = "robot_1: nothing is wrong with its pose";
            return true;
          });
  auto& table = *panel_.findChild<QTableWidget*>("robots");
  ASSERT_TRUE(waitUntil([&] { return table.rowCount() == 2; }));
  table.selectRow(1);
  ASSERT_TRUE(waitUntil([&] {
    return button("confirm_pose").text() == "Confirm pose of robot_1" &&
           button("pause").isEnabled();
  }));
  EXPECT_FALSE(button("confirm_pose").isEnabled());
  state_.mode = sylph_msgs::AdgState::STOP;
  ASSERT_TRUE(waitUntil([&] { return button("confirm_pose").isEnabled(); }));
  button("confirm_pose").click();
  EXPECT_TRUE(waitUntil([&] {
    return label("outcome") == "/robot_1/confirm_pose: robot_1: nothing is wrong with its pose";
  })) << label("outcome");
  EXPECT_EQ(1, calls);
}

TEST_F(OperatorPanelTest, CommandsAreOffInAReplay) {
  // A state of execution without a central node's services.
  EXPECT_TRUE(waitUntil([&] {
    return label("outcome") == "commands are off: a replay: no robot hears commands";
  })) << label("outcome");
  for (const char* name : {"start", "pause", "resume", "stop", "cancel", "confirm_pose"}) {
    EXPECT_FALSE(button(name).isEnabled()) << name;
  }
}

TEST_F(OperatorPanelTest, MovesAReplayThatCanBeMoved) {
  std::vector<double> places;
  const ros::Subscriber listener = suite_.subscribe<std_msgs::Float64>(
      sylph_ros::kReplaySeekTopic, 10,
      [&](const std_msgs::Float64::ConstPtr& place) { places.push_back(place->data); });
  auto& slider = *panel_.findChild<QSlider*>("replay");
  ASSERT_TRUE(waitUntil([&] { return !button("stop").isEnabled(); })) << "a replay";
  EXPECT_TRUE(slider.parentWidget()->isHidden());
  ros::Publisher replay =
      suite_.advertise<sylph_msgs::ReplayExtent>(sylph_ros::kReplayExtentTopic, 1, true);
  sylph_msgs::ReplayExtent extent;
  // The test runs by the wall clock.
  extent.begin = ros::Time::now() - ros::Duration(30.0);
  extent.length = ros::Duration(60.0);
  replay.publish(extent);
  ASSERT_TRUE(waitUntil([&] { return !slider.parentWidget()->isHidden(); }));
  EXPECT_EQ(600, slider.maximum()) << "tenths of a second";
  EXPECT_GE(slider.value(), 300);
  EXPECT_LE(slider.value(), 600);
  EXPECT_EQ(" of 1 min 00 s", label("replay_time").substr(label("replay_time").find(" of ")));
  EXPECT_TRUE(places.empty()) << "it moves by itself with the time";
  slider.setSliderDown(true);
  slider.setSliderPosition(125);
  EXPECT_EQ("12.5 s of 1 min 00 s", label("replay_time"));
  waitUntil([ticks = 0]() mutable { return ++ticks > 10; });
  EXPECT_TRUE(places.empty()) << "while it is dragged";
  EXPECT_EQ(125, slider.sliderPosition()) << "it was taken out of the hand";
  slider.setSliderDown(false);
  ASSERT_TRUE(waitUntil([&] { return !places.empty(); }));
  EXPECT_EQ(std::vector<double>{12.5}, places);
}

}  // namespace
}  // namespace sylph_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "operator_panel_test");
  const ros::NodeHandle keeps_ros_alive;
  const QApplication application(argc, argv);
  ros::AsyncSpinner spinner(4);
  spinner.start();
  return RUN_ALL_TESTS();
}
