#include <OgreCamera.h>
#include <actionlib/server/simple_action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rviz/render_panel.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/ExecuteMissionAction.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QThread>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "mission/small_lab.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"

namespace sylph_rviz {
namespace {

using sylph_msgs::ExecuteMissionGoal;
using sylph_msgs::ExecuteMissionResult;

/// A mock of a fleet in the small lab, whose robots stand on their starts:
///     0...2
///     .@@..
///     ....1
class MockFleet {
 public:
  MockFleet() {
    suite_.setCallbackQueue(&queue_);
    states_ = suite_.advertise<sylph_msgs::AdgState>(sylph_ros::kAdgStateTopic, 1);
    map_ = suite_.advertise<nav_msgs::OccupancyGrid>(
        sylph_ros::fleetName(suite_, sylph_ros::kMapTopic), 1, true);
    map_.publish(mapMessage());
    std::vector<geometry_msgs::TransformStamped> frames;
    for (const auto& [robot, pose] : sylph::posesInStarts()) {
      sylph_msgs::RobotExecution execution;
      execution.robot_id = robot;
      state_.robots.push_back(execution);
      geometry_msgs::TransformStamped frame;
      frame.header.frame_id = sylph_ros::kMapFrame;
      frame.child_frame_id = robot;
      frame.transform.translation.x = pose.pose.x_m;
      frame.transform.translation.y = pose.pose.y_m;
      frame.transform.rotation.w = 1.0;
      frames.push_back(frame);
      geometry_msgs::PoseStamped message;
      message.header.frame_id = sylph_ros::kMapFrame;
      message.pose.position.x = pose.pose.x_m;
      message.pose.position.y = pose.pose.y_m;
      message.pose.orientation.w = 1.0;
      poses_.push_back(suite_.advertise<geometry_msgs::PoseStamped>(
          sylph_ros::robotTopic(suite_, robot, sylph_ros::kPoseTopic), 1, true));
      poses_.back().publish(message);
    }
    broadcaster_.sendTransform(frames);
    selection_ = suite_.subscribe<std_msgs::String>(
        sylph_ros::kSelectedRobotTopic, 1, [this](const std_msgs::String::ConstPtr& robot) {
          const std::lock_guard<std::mutex> lock(mutex_);
          selected_ = robot->data;
        });
    pause_ = suite_.advertiseService<std_srvs::TriggerRequest, std_srvs::TriggerResponse>(
        sylph_ros::kPauseService,
        [this](std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response) {
          ++pauses;
          response.success = 1;
          return true;
        });
    plan_ = makeServer(sylph_ros::kPlanMissionAction, planned_, 3);
    execute_ = makeServer(sylph_ros::kExecuteMissionAction, executed_, 0);
    spinner_.start();
  }

  void publishState() { states_.publish(state_); }
  std::string selected() const { return locked(selected_); }
  /// The last goal of plan_mission.
  ExecuteMissionGoal planned() const { return locked(planned_); }
  /// The last goal of execute_mission.
  ExecuteMissionGoal executed() const { return locked(executed_); }

  std::atomic<int> pauses{0};

 private:
  using Server = actionlib::SimpleActionServer<sylph_msgs::ExecuteMissionAction>;

  static nav_msgs::OccupancyGrid mapMessage() {
    const sylph::Experiment lab = sylph::smallLab();
    nav_msgs::OccupancyGrid map;
    map.header.frame_id = sylph_ros::kMapFrame;
    map.info.width = static_cast<std::uint32_t>(lab.grid.cols());
    map.info.height = static_cast<std::uint32_t>(lab.grid.rows());
    map.info.resolution = static_cast<float>(lab.cell_size_m);
    map.info.origin.orientation.w = 1.0;
    map.data.resize(static_cast<std::size_t>(lab.grid.size()));
    return map;
  }

  /// Succeeds at once with everything.
  std::unique_ptr<Server> makeServer(const std::string& action, ExecuteMissionGoal& goal,
                                     std::uint32_t shown_plan) {
    auto server = std::make_unique<Server>(suite_, action, false);
    server->registerGoalCallback([this, raw = server.get(), &goal, shown_plan] {
      const auto accepted = raw->acceptNewGoal();
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        goal = *accepted;
      }
      ExecuteMissionResult result;
      result.shown_plan_id = shown_plan;
      result.message = "2 steps, checked";
      raw->setSucceeded(result);
    });
    server->start();
    return server;
  }

  template <typename Value>
  Value locked(const Value& value) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value;
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle suite_{"sylph"};
  mutable std::mutex mutex_;
  std::string selected_;
  ExecuteMissionGoal planned_;
  ExecuteMissionGoal executed_;
  sylph_msgs::AdgState state_;
  ros::Publisher states_;
  ros::Publisher map_;
  std::vector<ros::Publisher> poses_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  ros::Subscriber selection_;
  ros::ServiceServer pause_;
  std::unique_ptr<Server> plan_;
  std::unique_ptr<Server> execute_;
  ros::AsyncSpinner spinner_{2, &queue_};
};

/// RViz with the shipped configuration, and the operator's mouse.
class RvizTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    lab().fleet = std::make_unique<MockFleet>();
    std::string config;
    ros::param::get("~config", config);
    lab().frame = std::make_unique<rviz::VisualizationFrame>();
    lab().frame->setApp(qApp);
    lab().frame->setSplashPath("");
    lab().frame->initialize(QString::fromStdString(config));
    lab().frame->show();
    rviz::ViewController* view = lab().frame->getManager()->getViewManager()->getCurrent();
    view->subProp("X")->setValue(0.75);
    view->subProp("Y")->setValue(0.45);
    view->subProp("Scale")->setValue(400);
  }
  static void TearDownTestSuite() {
    lab().frame.reset();
    lab().fleet.reset();
  }

  void SetUp() override {
    ASSERT_NE(nullptr, find<QTableWidget>("robots")) << "the panel is not loaded";
    ASSERT_TRUE(waitUntil([] { return find<QTableWidget>("robots")->rowCount() == 3; }));
    press("clear_goals");
    ASSERT_TRUE(waitUntil([] { return label("goals").empty(); }));
    chooseTool("rviz/Interact");
  }

  template <typename Widget>
  static Widget* find(const char* name) {
    return lab().frame->findChild<Widget*>(name);
  }
  static std::string label(const char* name) { return find<QLabel>(name)->text().toStdString(); }
  static void press(const char* name) { find<QPushButton>(name)->click(); }

  static bool waitUntil(const std::function<bool()>& condition) {
    return sylph_ros::waitUntil(condition, [] {
      lab().fleet->publishState();
      QApplication::processEvents();
      QThread::msleep(10);
    });
  }

  /// What is under the mouse is found when a picture is drawn.
  static void waitForPictures() {
    const std::uint64_t last = lab().frame->getManager()->getFrameCount() + 3;
    EXPECT_TRUE(waitUntil([last] { return lab().frame->getManager()->getFrameCount() > last; }));
  }

  static void chooseTool(const QString& class_id) {
    rviz::ToolManager* tools = lab().frame->getManager()->getToolManager();
    for (int i = 0; i < tools->numTools(); ++i) {
      if (tools->getTool(i)->getClassId() == class_id) {
        tools->setCurrentTool(tools->getTool(i));
        return;
      }
    }
    FAIL() << class_id.toStdString() << " is not in the configuration";
  }

  static sylph::Point centerOf(const sylph::Cell& cell) {
    return cellFrameOf(sylph::smallLab()).toPoint(cell);
  }

  static void sendMouse(QEvent::Type type, const sylph::Point& at, Qt::MouseButton button,
                        Qt::MouseButtons buttons) {
    rviz::RenderPanel* panel = lab().frame->getManager()->getRenderPanel();
    const Ogre::Camera* camera = panel->getCamera();
    const Ogre::Vector3 place =
        camera->getProjectionMatrix() *
        (camera->getViewMatrix() *
         Ogre::Vector3(static_cast<float>(at.x), static_cast<float>(at.y), 0.0F));
    const auto x = 0.5 + 0.5 * static_cast<double>(place.x);
    const auto y = 0.5 - 0.5 * static_cast<double>(place.y);
    const QPoint pixel(static_cast<int>(x * panel->width()), static_cast<int>(y * panel->height()));
    QMouseEvent event(type, pixel, panel->mapToGlobal(pixel), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(panel, &event);
  }

  /// Without a way from one to the other this is a click.
  static void drag(const sylph::Point& from, const sylph::Point& to) {
    sendMouse(QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
    waitForPictures();
    sendMouse(QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
    waitForPictures();
    sendMouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    constexpr int kMoves = 5;
    for (int move = 1; move <= kMoves; ++move) {
      const double part = static_cast<double>(move) / kMoves;
      waitForPictures();
      sendMouse(QEvent::MouseMove, from + part * sylph::displacement(from, to), Qt::NoButton,
                Qt::LeftButton);
    }
    waitForPictures();
    sendMouse(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  }

  /// Of all tests, from SetUpTestSuite() to TearDownTestSuite(): RViz takes seconds to start.
  struct Lab {
    std::unique_ptr<MockFleet> fleet;
    std::unique_ptr<rviz::VisualizationFrame> frame;
  };
  static Lab& lab() {
    static Lab lab;
    return lab;
  }
};

TEST_F(RvizTest, AButtonOfThePanelReachesTheCentralNode) {
  ASSERT_TRUE(waitUntil([] { return find<QPushButton>("pause")->isEnabled(); }));
  press("pause");
  EXPECT_TRUE(waitUntil([] { return lab().fleet->pauses == 1; }));
}

TEST_F(RvizTest, AClickOnARobotSelectsIt) {
  drag(centerOf({2, 4}), centerOf({2, 4}));
  EXPECT_TRUE(waitUntil([] { return lab().fleet->selected() == "robot_1"; }))
      << lab().fleet->selected();
  EXPECT_TRUE(waitUntil([] { return find<QTableWidget>("robots")->item(1, 0)->isSelected(); }));
}

TEST_F(RvizTest, AGoalThatIsDraggedIsPlannedAndThenCarriedOut) {
  drag(centerOf({0, 0}), centerOf({0, 2}) + sylph::Vector2{0.08, 0.05});
  ASSERT_TRUE(waitUntil([] { return label("goals") == "robot_0 to (0,2); 2 robots stay"; }))
      << label("goals");
  EXPECT_FALSE(find<QPushButton>("go")->isEnabled()) << "nothing has been planned";
  press("plan");
  ASSERT_TRUE(waitUntil([] { return find<QPushButton>("go")->isEnabled(); })) << label("goals");
  EXPECT_EQ("robot_0 to (0,2); 2 robots stay\nplan 3: 2 steps, checked", label("goals"));
  const ExecuteMissionGoal planned = lab().fleet->planned();
  ASSERT_EQ(std::vector<std::string>{"robot_0"}, planned.robots);
  EXPECT_EQ((sylph::Cell{0, 2}), sylph_ros::fromMessage(planned.goals.at(0)));
  EXPECT_TRUE(lab().fleet->executed().robots.empty()) << "planning moves nobody";
  press("go");
  ASSERT_TRUE(waitUntil([] { return !lab().fleet->executed().robots.empty(); }));
  EXPECT_EQ(3U, lab().fleet->executed().shown_plan_id);
  EXPECT_EQ(planned.goals, lab().fleet->executed().goals);
}

TEST_F(RvizTest, AGoalThatIsTakenIsRefusedAndTheReasonTold) {
  drag(centerOf({0, 0}), centerOf({0, 4}));
  EXPECT_TRUE(waitUntil([] {
    return label("outcome") ==
           "goal (0,4) of robot_0 is where robot_2 stands, which has no part in the mission";
  })) << label("outcome");
  EXPECT_EQ("", label("goals"));
}

TEST_F(RvizTest, NavGoalIsForTheSelectedRobot) {
  find<QTableWidget>("robots")->selectRow(1);
  chooseTool("rviz/SetGoal");
  drag(centerOf({2, 1}), centerOf({2, 2}));
  EXPECT_TRUE(waitUntil([] { return label("goals") == "robot_1 to (2,1); 2 robots stay"; }))
      << label("goals") << label("outcome");
}

TEST_F(RvizTest, GoalsAreSavedAsAnExperiment) {
  const QTemporaryDir folder;
  drag(centerOf({2, 4}), centerOf({2, 3}));
  ASSERT_TRUE(waitUntil([] { return find<QPushButton>("save")->isEnabled(); }));
  press("save");
  auto* dialog = lab().frame->findChild<QFileDialog*>();
  ASSERT_NE(nullptr, dialog);
  Q_EMIT dialog->fileSelected(folder.filePath("mission.yaml"));
  dialog->close();
  const std::string path = folder.filePath("mission.yaml").toStdString();
  ASSERT_TRUE(waitUntil([&] { return label("outcome") == "save: " + path + " is written"; }))
      << label("outcome");
  const sylph::Experiment saved = sylph::loadExperiment(path);
  EXPECT_EQ((sylph::Cell{2, 3}), saved.robots.at(1).goal);
  EXPECT_EQ(saved.robots.at(0).start, saved.robots.at(0).goal);
}

}  // namespace
}  // namespace sylph_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rviz_test");
  const ros::NodeHandle keeps_ros_alive;
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
