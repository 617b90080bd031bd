#include "sylph_planner_node/send_command.hpp"

#include <actionlib/client/simple_action_client.h>
#include <sylph_msgs/ExecuteMissionAction.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_core/mission/checked_plan.hpp"
#include "sylph_core/mission/goal_judge.hpp"
#include "sylph_core/text/join.hpp"
#include "sylph_planner_node/mission_client.hpp"
#include "sylph_planner_node/mission_request.hpp"
#include "sylph_planner_node/mission_text.hpp"
#include "sylph_planner_node/planner_watch.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

constexpr double kPoseTimeoutS = 0.5;
const ros::WallDuration kPollPeriod{0.05};
constexpr double kReminderPeriodS = 2.0;

ros::NodeHandle servedBy(const ros::NodeHandle& nh, ros::CallbackQueue& queue) {
  ros::NodeHandle own(nh);
  own.setCallbackQueue(&queue);
  return own;
}

}  // namespace

SendCommand::SendCommand(const ros::NodeHandle& nh, sylph::Experiment lab, SendRequest request)
    : nh_(nh),
      lab_(std::move(lab)),
      request_(std::move(request)),
      participants_(withParticipants(lab_, request_.goals, request_.others_give_way)),
      clock_(sylph_ros::SteadyClock::ofSpectator(nh)),
      poses_(servedBy(nh, queue_), clock_) {
  status_subscriber_ = servedBy(nh, queue_)
                           .subscribe<actionlib_msgs::GoalStatusArray>(
                               std::string(sylph_ros::kExecuteMissionAction) + "/status", 1,
                               [this](const actionlib_msgs::GoalStatusArray::ConstPtr& status) {
                                 status_ = *status;
                               });
  plan_subscriber_ =
      servedBy(nh, queue_)
          .subscribe<sylph_msgs::JointActions>(
              sylph_ros::kShownPlanTopic, 1,
              [this](const sylph_msgs::JointActions::ConstPtr& plan) { plan_ = *plan; });
  poses_.start(namesOf(lab_));
}

int SendCommand::run() {
  waitUntilReady();
  if (sylph_ros::isUnderWay(*status_) && !request_.replaces) {
    throw std::runtime_error("a mission is under way: wait for its end, or --replace it");
  }
  const sylph::RobotPoses poses = poses_.judged(kPoseTimeoutS * clock_.speed());
  poses_.stop();
  const sylph::Experiment experiment =
      toExperiment(request_, participants_, startCells(toMission(participants_), poses));
  const sylph::Mission mission = toMission(experiment);
  requireGoals(mission);
  startOf(mission, lab_.robots, poses, true, bystanderDistance(lab_));
  const sylph_msgs::ExecuteMissionGoal goal = sylph_ros::toGoal(experiment);
  if (!request_.save_path.empty()) {
    saveExperiment(toExperiment(request_, lab_, startCells(toMission(lab_), poses)),
                   request_.save_path);
    std::cout << request_.save_path << " is written" << std::endl;
  }
  const std::string headline =
      headlineOf(request_.goals, lab_.robots.size(), request_.others_give_way);
  if (request_.plan_only) {
    std::cout << headline << std::endl;
    return showPlan(goal);
  }
  ClientOptions options;
  options.start_timeout_s = request_.wait_s;
  return MissionClient(nh_, options, experiment, goal, headline).run() ? EXIT_SUCCESS
                                                                       : EXIT_FAILURE;
}

int SendCommand::showPlan(const sylph_msgs::ExecuteMissionGoal& goal) {
  actionlib::SimpleActionClient<sylph_msgs::ExecuteMissionAction> planner(
      nh_, sylph_ros::kPlanMissionAction, false);
  const ros::WallTime last = ros::WallTime::now() + ros::WallDuration(request_.wait_s);
  while (ros::ok() && !planner.isServerConnected()) {
    if (ros::WallTime::now() > last) {
      throw std::runtime_error("no planner: nobody serves the action " +
                               nh_.resolveName(sylph_ros::kPlanMissionAction));
    }
    kPollPeriod.sleep();
  }
  std::cout << "planning for up to " << goal.time_limit_s << " s" << std::endl;
  const PlannerWatch watch(nh_, sylph_ros::kPlanMissionAction, request_.wait_s);
  planner.sendGoal(goal);
  while (ros::ok() && !planner.getState().isDone()) {
    watch.requireAlive(planner.isServerConnected());
    kPollPeriod.sleep();
  }
  const auto result = planner.getResult();
  if (!result || result->outcome != sylph_msgs::ExecuteMissionResult::SUCCESS) {
    throw std::runtime_error(result ? result->message : "the planner has given no answer");
  }
  std::cout << "plan " << result->shown_plan_id << ": " << result->message << std::endl;
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(request_.wait_s);
  while (ros::ok() && plan_.plan_id != result->shown_plan_id && ros::WallTime::now() < deadline) {
    queue_.callAvailable(kPollPeriod);
  }
  if (plan_.plan_id == result->shown_plan_id) {
    std::cout << waysText(sylph_ros::fromMessage(plan_));
  }
  std::cout << "nothing has been moved" << std::endl;
  return EXIT_SUCCESS;
}

void SendCommand::waitUntilReady() {
  const ros::WallTime begin = ros::WallTime::now();
  ros::WallTime next_reminder = begin + ros::WallDuration(kReminderPeriodS);
  for (auto missing = whatIsMissing(lab_); missing && ros::ok(); missing = whatIsMissing(lab_)) {
    const ros::WallTime now = ros::WallTime::now();
    if ((now - begin).toSec() > request_.wait_s) {
      // Whether it can be done without the others the planner decides, but an experiment has all.
      missing = whatIsMissing(request_.save_path.empty() ? participants_ : lab_);
      if (!missing) {
        break;
      }
      throw std::runtime_error(*missing);
    }
    if (now > next_reminder) {
      std::cout << "waiting: " << *missing << std::endl;
      next_reminder += ros::WallDuration(kReminderPeriodS);
    }
    queue_.callAvailable(kPollPeriod);
  }
  if (!ros::ok()) {
    throw std::runtime_error("interrupted: no mission is sent");
  }
}

std::optional<std::string> SendCommand::whatIsMissing(const sylph::Experiment& robots) const {
  if (!status_) {
    return "no planner: nobody serves the action " +
           nh_.resolveName(sylph_ros::kExecuteMissionAction);
  }
  const sylph::RobotPoses poses = poses_.judged(kPoseTimeoutS * clock_.speed());
  std::vector<std::string> unseen;
  std::string fault;
  for (const std::string& robot : namesOf(robots)) {
    const auto pose = poses.find(robot);
    if (pose == poses.end() || !pose->second.fault.empty()) {
      unseen.push_back(robot);
      fault = pose == poses.end() ? "none has come" : "it " + pose->second.fault;
    }
  }
  if (unseen.empty()) {
    return std::nullopt;
  }
  return "no good pose of " + sylph::join(unseen) + " (" + fault + ")";
}

}  // namespace sylph_planner_node
