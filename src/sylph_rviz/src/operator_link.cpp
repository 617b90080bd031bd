#include "sylph_rviz/operator_link.hpp"

#include <nav_msgs/OccupancyGrid.h>
#include <ros/master.h>
#include <ros/service.h>
#include <sylph_msgs/AdgState.h>

#include <chrono>
#include <exception>

#include "sylph_ros/measured_pose.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_rviz {
namespace {

/// Longest wait for the answer of a service, in wall time.
constexpr double kServiceTimeoutS = 2.0;
/// Poses come faster than anybody reads: of each topic the last message in this time counts.
constexpr std::chrono::milliseconds kCallbackPeriod{50};
constexpr int kPeriodsPerLook = 20;

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
      pause_(suite_nh, sylph_ros::kPauseService, kServiceTimeoutS),
      resume_(suite_nh, sylph_ros::kResumeService, kServiceTimeoutS),
      stop_(suite_nh, sylph_ros::kStopService, kServiceTimeoutS) {
  nh_.setCallbackQueue(&queue_);
  client_ = std::make_unique<Client>(nh_, sylph_ros::kExecuteMissionAction, false);
  subscribers_.push_back(nh_.subscribe(sylph_ros::kAdgStateTopic, 1, &OperatorLink::onState, this));
  subscribers_.push_back(
      nh_.subscribe<nav_msgs::OccupancyGrid>(sylph_ros::fleetName(nh_, sylph_ros::kMapTopic), 1,
                                             [this](const nav_msgs::OccupancyGrid::ConstPtr& map) {
                                               const std::lock_guard<std::mutex> lock(mutex_);
                                               model_.onMap(*map);
                                             }));
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
  callbacks_ = std::thread([this] { serveCallbacks(); });
  graph_ = std::thread([this] { watchGraph(); });
}

OperatorLink::~OperatorLink() {
  is_ending_ = true;
  callbacks_.join();
  graph_.join();
  if (start_.valid()) {
    start_.wait();
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
    const std::lock_guard<std::mutex> lock(mutex_);
    outcome_ = outcome;
  });
}

void OperatorLink::cancel() {
  client_->cancelAllGoals();
  const std::lock_guard<std::mutex> lock(mutex_);
  outcome_ = "cancel: robots hold at their next cells";
}

void OperatorLink::confirmPose(const std::string& robot) {
  confirm_pose_ = std::make_unique<TriggerCall>(
      nh_, sylph_ros::robotTopic(nh_, robot, sylph_ros::kConfirmPoseService), kServiceTimeoutS);
  confirm_pose_->call();
}

void OperatorLink::serveCallbacks() {
  while (!is_ending_) {
    queue_.callAvailable();
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
  if (!lab_path.empty() && lab_path != lab_path_) {
    std::vector<ExperimentChoice> choices;
    try {
      choices = experimentChoices(lab_path);
    } catch (const std::exception&) {
      choices.clear();  // on another computer, perhaps
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    experiments_ = choices;
  }
  lab_path_ = lab_path;
  const bool has_planner = client_->isServerConnected();
  const std::lock_guard<std::mutex> lock(mutex_);
  model_.setSource(source, has_planner);
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

}  // namespace sylph_rviz
