#include "sylph_planner_node/plan_server.hpp"

#include <ros/console.h>

#include <chrono>
#include <stdexcept>
#include <utility>
#include <variant>

#include "sylph_planner_node/mission_messages.hpp"
#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {

using sylph::MissionFailure;
using sylph::MissionOutcome;
using Stage = sylph::PlanPreview::Stage;

PlanServer::PlanServer(const ros::NodeHandle& nh, const Options& options,
                       const sylph::MissionLimits& limits, const sylph::Experiment& lab,
                       Weights& weights, const sylph_ros::SteadyClock& clock)
    : options_(options),
      lab_(lab),
      weights_(weights),
      clock_(clock),
      poses_(nh, clock),
      publisher_(ros::NodeHandle(nh).advertise<sylph_msgs::JointActions>(sylph_ros::kShownPlanTopic,
                                                                         1, true)),
      preview_(lab.robots, limits),
      server_(nh, sylph_ros::kPlanMissionAction, false) {
  server_.registerGoalCallback([this] { onGoal(); });
  server_.registerPreemptCallback([this] { onPreempt(); });
  server_.start();
}

void PlanServer::onGoal() {
  const auto goal = server_.acceptNewGoal();
  preview_.cancel();
  withdraw();
  try {
    sylph::Mission mission = readMission(*goal, lab_, weights_);
    mission.search_steps_per_s = options_.search_steps_per_s;
    preview_.ask(std::move(mission), clock_.now());
    feedback_sent_s_ = 0.0;
    poses_.start(namesOf(lab_));
  } catch (const MissionFailure& failure) {
    fail(failure);
  }
}

void PlanServer::onPreempt() {
  if (server_.isActive() && !server_.isNewGoalAvailable()) {
    sylph_msgs::ExecuteMissionResult result;
    result.outcome = sylph_msgs::ExecuteMissionResult::PREEMPTED;
    result.message = "planning was cancelled";
    preview_.cancel();
    server_.setPreempted(result, result.message);
  }
}

void PlanServer::tick(bool is_mission_under_way) {
  if (planning_.valid() &&
      planning_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    preview_.onPlanned(planning_.get());
  }
  publishFeedback();
  if (auto task = preview_.tick(poses_.judged(options_.pose_timeout_s), is_mission_under_way,
                                clock_.now())) {
    for (const std::string& line : task->ignored) {
      ROS_WARN("%s; it is ignored", line.c_str());
    }
    planning_ = std::async(std::launch::async, std::move(task->make));
  }
  if (const auto outcome = preview_.takeAnswer()) {
    answer(*outcome);
  }
  if (preview_.stage() != Stage::Starting) {
    poses_.stop();
  }
}

void PlanServer::answer(const sylph::PlanningOutcome& outcome) {
  if (const auto* failure = std::get_if<MissionFailure>(&outcome)) {
    fail(*failure);
    return;
  }
  const auto& plan = std::get<sylph::CheckedPlan>(outcome);
  try {
    show(plan);
  } catch (const std::invalid_argument& error) {
    preview_.withdraw();
    fail({MissionOutcome::NoPlan, std::string("the plan cannot be shown: ") + error.what()});
    return;
  }
  sylph_msgs::ExecuteMissionResult result;
  result.outcome = sylph_msgs::ExecuteMissionResult::SUCCESS;
  result.message = certificateOf(plan);
  result.robots = static_cast<std::uint32_t>(preview_.mission().robots.size());
  result.plan_steps = static_cast<std::uint32_t>(plan.metrics.steps);
  result.sum_of_costs = static_cast<std::uint32_t>(plan.metrics.sum_of_costs);
  result.planning_s = plan.planning_s;
  result.shown_plan_id = preview_.number();
  server_.setSucceeded(result, result.message);
}

void PlanServer::show(const sylph::CheckedPlan& plan) {
  const sylph::Mission& mission = preview_.mission();
  sylph::MissionPlan shown = toMissionPlan(plan, mission.robots, mission.planner);
  shown.plan_id = preview_.number();
  sylph_msgs::JointActions message = sylph_ros::toMessage(shown);
  message.header.stamp = clock_.stamp();
  publisher_.publish(message);
}

void PlanServer::fail(const MissionFailure& failure) {
  sylph_msgs::ExecuteMissionResult result;
  result.outcome = static_cast<std::uint8_t>(failure.outcome());
  result.message = failure.what();
  server_.setAborted(result, result.message);
}

void PlanServer::publishFeedback() {
  if (preview_.stage() == Stage::Idle ||
      clock_.now() - feedback_sent_s_ < options_.feedback_period_s) {
    return;
  }
  feedback_sent_s_ = clock_.now();
  sylph_msgs::ExecuteMissionFeedback feedback;
  feedback.phase = preview_.stage() == Stage::Planning ? "planning" : "starting";
  if (!preview_.waitsFor().empty()) {
    feedback.waiting.push_back(preview_.waitsFor());
  }
  server_.publishFeedback(feedback);
}

void PlanServer::withdraw() {
  preview_.withdraw();
  publisher_.publish(sylph_msgs::JointActions());
}

}  // namespace sylph_planner_node
