#include "sylph_rviz/operator_link.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/master.h>
#include <ros/service.h>
#include <std_msgs/Float64.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/JointActions.h>
#include <sylph_msgs/ReplayExtent.h>

#include <chrono>
#include <exception>
#include <utility>

#include "sylph_core/mission/mission.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/measured_pose.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_rviz/conversions.hpp"
#include "sylph_rviz/layers.hpp"

namespace sylph_rviz {
namespace {

/// Longest wait for the answer of a service, in wall time.
constexpr double kServiceTimeoutS = 2.0;
/// Poses come faster than anybody reads: of each topic the last message in this time counts.
constexpr std::chrono::milliseconds kCallbackPeriod{50};
constexpr int kPeriodsPerLook = 20;
/// Of the goals that are set: as often as any layer, see MarkersNode.
constexpr int kPeriodsPerPicture = 2;

double steadyTime() {
  return ros::SteadyTime::now().toSec();
}

/// Whether the master's list of one kind, as of getSystemState, has a node behind `name`.
bool hasProvider(XmlRpc::XmlRpcValue& list, const std::string& name) {
  // NOLINTNEXTLINE(modernize-loop-convert): an array of XmlRpc has no iterators.
  for (int i = 0; i < list.size(); ++i) {
    if (static_cast<std::string>(list[i][0]) == name) {
      return list[i][1].size() > 0;
    }
  }
  return false;
}

}  // namespace

OperatorLink::OperatorLink(const ros::NodeHandle& suite_nh)
    : nh_(suite_nh),
      markers_(suite_nh),
      pause_(suite_nh, sylph_ros::kPauseService, kServiceTimeoutS),
      resume_(suite_nh, sylph_ros::kResumeService, kServiceTimeoutS),
      stop_(suite_nh, sylph_ros::kStopService, kServiceTimeoutS),
      capture_findings_(suite_nh.getNamespace()) {
  nh_.setCallbackQueue(&queue_);
  client_ = std::make_unique<Client>(nh_, sylph_ros::kExecuteMissionAction, false);
  subscribers_.push_back(nh_.subscribe(sylph_ros::kAdgStateTopic, 1, &OperatorLink::onState, this));
  subscribers_.push_back(
      nh_.subscribe<nav_msgs::OccupancyGrid>(sylph_ros::fleetName(nh_, sylph_ros::kMapTopic), 1,
                                             [this](const nav_msgs::OccupancyGrid::ConstPtr& map) {
                                               const std::lock_guard<std::mutex> lock(mutex_);
                                               model_.onMap(*map);
                                             }));
  subscribers_.push_back(nh_.subscribe<sylph_msgs::JointActions>(
      sylph_ros::kJointActionsTopic, 1, [this](const sylph_msgs::JointActions::ConstPtr& message) {
        if (auto plan = planOf(*message)) {
          const std::lock_guard<std::mutex> lock(mutex_);
          model_.onPlan(std::move(*plan));
        }
      }));
  subscribers_.push_back(nh_.subscribe<sylph_msgs::ReplayExtent>(
      sylph_ros::kReplayExtentTopic, 1, [this](const sylph_msgs::ReplayExtent::ConstPtr& extent) {
        const std::lock_guard<std::mutex> lock(mutex_);
        model_.onReplayExtent(*extent);
      }));
  subscribers_.push_back(nh_.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& diagnostics) {
        capture_findings_.note(*diagnostics);
        const std::lock_guard<std::mutex> lock(mutex_);
        model_.setCaptureFindings(capture_findings_.lines());
      }));
  seek_ = nh_.advertise<std_msgs::Float64>(sylph_ros::kReplaySeekTopic, 1);
  // Of the action's topics and not of its client, so that missions of others are seen, too.
  const std::string action = sylph_ros::kExecuteMissionAction;
  subscribers_.push_back(nh_.subscribe<sylph_msgs::ExecuteMissionActionFeedback>(
      action + "/feedback", 1,
      [this](const sylph_msgs::ExecuteMissionActionFeedback::ConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        model_.onFeedback(message->feedback, steadyTime());
      }));
  subscribers_.push_back(nh_.subscribe<sylph_msgs::ExecuteMissionActionResult>(
      action + "/result", 5,
      [this](const sylph_msgs::ExecuteMissionActionResult::ConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        model_.onResult(message->result);
      }));
  // Its own words come back here, and those of another panel or of the shell.
  selected_robot_ = std::make_unique<SelectedRobot>(nh_, [this](const std::string& robot) {
    const std::lock_guard<std::mutex> lock(mutex_);
    model_.select(robot);
  });
  listenToGoals();
  callbacks_ = std::thread([this] { serveCallbacks(); });
  graph_ = std::thread([this] { watchGraph(); });
}

OperatorLink::~OperatorLink() {
  is_ending_ = true;
  callbacks_.join();
  graph_.join();
  for (std::future<void>* work : {&start_, &save_}) {
    if (work->valid()) {
      work->wait();
    }
  }
}

OperatorView OperatorLink::view() const {
  const ros::Time now = ros::Time::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  return model_.view(now.toSec(), steadyTime());
}

std::vector<ExperimentChoice> OperatorLink::experiments() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return experiments_;
}

std::string OperatorLink::takeOutcome() {
  for (TriggerCall* call : {&pause_, &resume_, &stop_, confirm_pose_.get()}) {
    if (call == nullptr) {
      continue;
    }
    if (std::string outcome = call->takeOutcome(); !outcome.empty()) {
      return outcome;
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(outcome_, "");
}

void OperatorLink::select(const std::string& robot) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    model_.select(robot);
  }
  selected_robot_->set(robot);
}

void OperatorLink::seek(double place_s) {
  std_msgs::Float64 message;
  message.data = place_s;
  seek_.publish(message);
}

void OperatorLink::start(const MissionChoice& choice) {
  // A second press while the first is at work asks for the same.
  if (start_.valid() && start_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return;
  }
  start_ = std::async(std::launch::async, [this, choice] {
    std::string outcome;
    try {
      sylph::ExperimentOverrides overrides;
      overrides.seed = choice.seed;
      if (!choice.planner.empty()) {
        overrides.planner = choice.planner;
      }
      client_->sendGoal(
          sylph_ros::toGoal(sylph::loadExperiment(choice.experiment_path, overrides)));
      outcome = "start: mission sent";
    } catch (const std::exception& error) {
      outcome = std::string("start: ") + error.what();
    }
    tell(outcome);
  });
}

void OperatorLink::cancel() {
  client_->cancelAllGoals();
  tell("cancel: robots hold at their next cells");
}

void OperatorLink::confirmPose(const std::string& robot) {
  confirm_pose_ = std::make_unique<TriggerCall>(
      nh_, sylph_ros::robotTopic(nh_, robot, sylph_ros::kConfirmPoseService), kServiceTimeoutS);
  confirm_pose_->call();
}

void OperatorLink::serveCallbacks() {
  for (int period = 0; !is_ending_; ++period) {
    queue_.callAvailable();
    serveMouse(period % kPeriodsPerPicture == 0);
    std::this_thread::sleep_for(kCallbackPeriod);
  }
}

void OperatorLink::watchGraph() {
  for (int period = 0; !is_ending_; ++period) {
    if (period % kPeriodsPerLook == 0) {
      lookAround();
    }
    std::this_thread::sleep_for(kCallbackPeriod);
  }
}

void OperatorLink::lookAround() {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue graph;
  request[0] = ros::this_node::getName();
  Source source = Source::None;
  if (ros::master::execute("getSystemState", request, response, graph, false) &&
      hasProvider(graph[0], nh_.resolveName(sylph_ros::kAdgStateTopic))) {
    // A bag that is played has the topics of a central node and none of its services.
    source = hasProvider(graph[2], nh_.resolveName(sylph_ros::kPauseService)) ? Source::Live
                                                                              : Source::Replay;
  }
  std::string lab_path;
  nh_.getParam(sylph_ros::kExperimentParameter, lab_path);
  if (lab_path != lab_path_) {
    takeLab(lab_path);
  }
  const bool has_planner = client_->isServerConnected();
  const std::lock_guard<std::mutex> lock(mutex_);
  model_.setSource(source, has_planner);
}

void OperatorLink::takeLab(const std::string& path) {
  lab_path_ = path;
  std::vector<ExperimentChoice> choices;
  std::optional<sylph::Experiment> lab;
  if (!path.empty()) {
    try {
      choices = experimentChoices(path);
      lab = sylph_ros::loadExperiment(nh_);
    } catch (const std::exception&) {
      choices.clear();  // on another computer, perhaps
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  experiments_ = choices;
  try {
    model_.desk().setLab(lab);
  } catch (const std::exception& error) {
    model_.desk().setLab(std::nullopt);
    outcome_ = error.what();
  }
}

void OperatorLink::onState(const sylph_msgs::AdgState& state) {
  for (const sylph_msgs::RobotExecution& robot : state.robots) {
    if (!robot.robot_id.empty() && poses_.count(robot.robot_id) == 0) {
      listenToPose(robot.robot_id);
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  model_.onState(state, steadyTime());
}

void OperatorLink::listenToPose(const std::string& robot) {
  poses_[robot] = nh_.subscribe<geometry_msgs::PoseStamped>(
      sylph_ros::robotTopic(nh_, robot, sylph_ros::kPoseTopic), 1,
      [this, robot](const geometry_msgs::PoseStamped::ConstPtr& message) {
        const sylph_ros::JudgedPose judged = sylph_ros::judgePose(*message);
        if (judged.fault == sylph_ros::PoseFault::None) {
          const std::lock_guard<std::mutex> lock(mutex_);
          model_.onPose(robot, judged.pose, message->header.stamp.toSec());
        }
      });
}

void OperatorLink::tell(const std::string& outcome) {
  const std::lock_guard<std::mutex> lock(mutex_);
  outcome_ = outcome;
}

void OperatorLink::listenToGoals() {
  plan_client_ = std::make_unique<Client>(nh_, sylph_ros::kPlanMissionAction, false);
  goals_ = nh_.advertise<visualization_msgs::MarkerArray>(kGoalLayerTopic, 1);
  subscribers_.push_back(
      nh_.subscribe(sylph_ros::kNavGoalTopic, 1, &OperatorLink::onNavGoal, this));
}

void OperatorLink::serveMouse(bool sends_goals) {
  const std::vector<GoalEvent> events = markers_.takeEvents();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool is_outdated = events[i].kind == GoalEvent::Kind::Drag && i + 1 < events.size();
    if (!is_outdated) {
      onMouse(events[i]);
    }
  }
  std::vector<GoalHandle> handles;
  double cell_size_m = 0.0;
  std::optional<Markers> layer;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Scene& scene = model_.scene();
    handles = model_.handles(steadyTime());
    cell_size_m = scene.map ? scene.map->cell_size_m : 0.0;
    if (sends_goals && goals_.getNumSubscribers() > 0) {
      layer = model_.desk().markers(scene);
    }
  }
  // The server of the markers has a lock of its own, which its thread holds when it calls here.
  markers_.show(handles, cell_size_m);
  if (layer) {
    goals_.publish(goals_history_.update(std::move(*layer), 0.0, steadyTime()));
  }
}

void OperatorLink::onMouse(const GoalEvent& event) {
  switch (event.kind) {
    case GoalEvent::Kind::Select:
      select(event.robot);
      break;
    case GoalEvent::Kind::Drag: {
      const std::lock_guard<std::mutex> lock(mutex_);
      model_.desk().drag(event.robot, event.point, model_.poses());
      break;
    }
    case GoalEvent::Kind::Drop:
      setGoal(event.robot, event.point);
      break;
  }
}

void OperatorLink::setGoal(const std::string& robot, const sylph::Point& point) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Refusal refusal = model_.view(0.0, steadyTime()).set_goal;
  outcome_ = refusal.empty() ? model_.desk().set(robot, point, model_.poses())
                             : "no goal is set: " + refusal;
}

void OperatorLink::onNavGoal(const geometry_msgs::PoseStamped& goal) {
  const sylph_ros::JudgedPose judged = sylph_ros::judgePose(goal);
  const std::string robot = view().selected;
  if (judged.fault != sylph_ros::PoseFault::None) {
    tell("2D Nav Goal: the pose " + judged.reason);
  } else if (robot.empty()) {
    tell("2D Nav Goal: select a robot first, by its row or by a click on it");
  } else {
    setGoal(robot, sylph::position(judged.pose));
  }
}

void OperatorLink::plan() {
  std::optional<sylph_msgs::ExecuteMissionGoal> goal;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    GoalDesk& desk = model_.desk();
    try {
      planned_ = sylph_ros::toGoal(desk.draft().value().mission(model_.poses()));
    } catch (const sylph::MissionFailure& failure) {
      outcome_ = std::string("plan: ") + failure.what();
      return;
    }
    desk.onSent();
    outcome_ = "plan: the planner is asked";
    goal = planned_;
  }
  plan_client_->sendGoal(*goal, [this](const actionlib::SimpleClientGoalState& state,
                                       const sylph_msgs::ExecuteMissionResultConstPtr& result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    sylph_msgs::ExecuteMissionResult answer;
    answer.message = "the planner has given no answer: " + state.toString();
    model_.desk().onPlanned(result ? *result : answer);
    outcome_ = model_.desk().shownPlan() == 0 ? "plan: there is none"
                                              : "plan: shown, nothing has been moved";
  });
}

void OperatorLink::go() {
  std::optional<sylph_msgs::ExecuteMissionGoal> goal;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::uint32_t shown_plan = model_.desk().shownPlan();
    if (!planned_ || shown_plan == 0) {
      outcome_ = "go: " + model_.desk().go();
      return;
    }
    goal = std::exchange(planned_, std::nullopt);
    goal->shown_plan_id = shown_plan;
    model_.desk().clear();
    outcome_ = "go: plan " + std::to_string(shown_plan) + " sent";
  }
  client_->sendGoal(*goal);
}

void OperatorLink::clearGoals() {
  const std::lock_guard<std::mutex> lock(mutex_);
  model_.desk().clear();
  outcome_ = "goals taken back";
}

void OperatorLink::setOthersGiveWay(bool others_give_way) {
  const std::lock_guard<std::mutex> lock(mutex_);
  model_.desk().setOthersGiveWay(others_give_way);
}

void OperatorLink::save(const std::string& path) {
  if (save_.valid() && save_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return;
  }
  save_ = std::async(std::launch::async, [this, path] {
    try {
      std::unique_lock<std::mutex> lock(mutex_);
      const sylph::Experiment mission = model_.desk().draft().value().experiment(model_.poses());
      lock.unlock();
      saveExperiment(mission, path);
      tell("save: " + path + " is written");
    } catch (const std::exception& error) {
      tell(std::string("save: ") + error.what());
    }
  });
}

}  // namespace sylph_rviz
