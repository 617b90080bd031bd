#include "sylph_planner_node/plan_server.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>
#include <variant>

#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_planner_node/mission_messages.hpp"
#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {

using sylph::MissionFailure;
using sylph::MissionOutcome;

PlanServer::PlanServer(const ros::NodeHandle& nh, const Options& options,
                       const sylph::Experiment& lab, Weights& weights,
                       const sylph_ros::SteadyClock& clock)
    : options_(options),
      lab_(lab),
      weights_(weights),
      clock_(clock),
      poses_(nh, clock),
      publisher_(ros::NodeHandle(nh).advertise<sylph_msgs::JointActions>(sylph_ros::kShownPlanTopic,
                                                                         1, true)),
      server_(nh, sylph_ros::kPlanMissionAction, false) {
  server_.registerGoalCallback([this] { onGoal(); });
  server_.registerPreemptCallback([this] { onPreempt(); });
  server_.start();
}

void PlanServer::onGoal() {
  const auto goal = server_.acceptNewGoal();
  withdraw();
  is_for_wanted_ = false;
  try {
    wanted_ = readMission(*goal, lab_, weights_);
    wanted_->search_steps_per_s = options_.search_steps_per_s;
    wanted_since_s_ = clock_.now();
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
    wanted_.reset();
    server_.setPreempted(result, result.message);
  }
}

void PlanServer::tick(bool is_mission_under_way) {
  if (planning_.valid() &&
      planning_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    sylph::PlanningOutcome outcome = planning_.get();
    if (wanted_ && is_for_wanted_) {
      onPlanned(std::move(outcome));
    }
  }
  if (!wanted_) {
    poses_.stop();
    return;
  }
  publishFeedback(is_for_wanted_ ? "planning" : "starting");
  if (is_for_wanted_ || planning_.valid()) {
    return;  // a plan that nobody waits for any more has to be waited for
  }
  try {
    if (is_mission_under_way) {
      throw MissionFailure(MissionOutcome::BadRequest,
                           "a mission is under way: plan when it has ended, or cancel it");
    }
    start();
  } catch (const MissionFailure& failure) {
    waits_for_ = failure.what();
    if (failure.outcome() != MissionOutcome::NoPose || hasWaitedForPoses()) {
      fail(failure);
    }
  }
}

bool PlanServer::hasWaitedForPoses() const {
  return clock_.now() - wanted_since_s_ > options_.limits.pose_wait_s * clock_.speed();
}

void PlanServer::start() {
  const sylph::MissionStart begin = startOf(
      *wanted_, lab_.robots, poses_.judged(options_.pose_timeout_s),
      options_.limits.ignores_unseen_robots && hasWaitedForPoses(), bystanderDistance(lab_));
  for (const std::string& line : begin.unseen) {
    ROS_WARN("%s; it is ignored", line.c_str());
  }
  waits_for_.clear();
  is_for_wanted_ = true;
  planning_ = std::async(std::launch::async, [mission = *wanted_, begin] {
    return sylph::outcomeOf([&] { return planMission(mission, begin.instance); });
  });
}

void PlanServer::onPlanned(sylph::PlanningOutcome outcome) {
  if (const auto* failure = std::get_if<MissionFailure>(&outcome)) {
    fail(*failure);
    return;
  }
  const auto& plan = std::get<sylph::CheckedPlan>(outcome);
  try {
    sylph::MissionPlan shown = toMissionPlan(plan, wanted_->robots, wanted_->planner);
    shown.plan_id = number_ + 1;
    sylph_msgs::JointActions message = sylph_ros::toMessage(shown);
    message.header.stamp = clock_.stamp();
    publisher_.publish(message);
  } catch (const std::invalid_argument& error) {
    fail({MissionOutcome::NoPlan, std::string("the plan cannot be shown: ") + error.what()});
    return;
  }
  sylph_msgs::ExecuteMissionResult result;
  result.outcome = sylph_msgs::ExecuteMissionResult::SUCCESS;
  result.message = certificateOf(plan);
  result.robots = static_cast<std::uint32_t>(wanted_->robots.size());
  result.plan_steps = static_cast<std::uint32_t>(plan.metrics.steps);
  result.sum_of_costs = static_cast<std::uint32_t>(plan.metrics.sum_of_costs);
  result.planning_s = plan.planning_s;
  result.shown_plan_id = ++number_;
  shown_mission_ = std::move(*wanted_);
  shown_plan_ = plan;
  wanted_.reset();
  server_.setSucceeded(result, result.message);
}

void PlanServer::fail(const MissionFailure& failure) {
  sylph_msgs::ExecuteMissionResult result;
  result.outcome = static_cast<std::uint8_t>(failure.outcome());
  result.message = failure.what();
  wanted_.reset();
  server_.setAborted(result, result.message);
}

void PlanServer::publishFeedback(const std::string& phase) {
  if (clock_.now() - feedback_sent_s_ < options_.feedback_period_s) {
    return;
  }
  feedback_sent_s_ = clock_.now();
  sylph_msgs::ExecuteMissionFeedback feedback;
  feedback.phase = phase;
  if (!waits_for_.empty()) {
    feedback.waiting.push_back(waits_for_);
  }
  server_.publishFeedback(feedback);
}

sylph::CheckedPlan PlanServer::planOf(std::uint32_t number, const sylph::Mission& mission) const {
  if (!shown_plan_ || number != number_) {
    throw MissionFailure(MissionOutcome::BadRequest,
                         "plan " + std::to_string(number) + " is not shown any more: plan again");
  }
  if (mission.robots != shown_mission_.robots || mission.goals != shown_mission_.goals ||
      mission.grid != shown_mission_.grid) {
    throw MissionFailure(
        MissionOutcome::BadRequest,
        "plan " + std::to_string(number) + " is of other robots, goals or map: plan again");
  }
  return *shown_plan_;
}

void PlanServer::withdraw() {
  shown_plan_.reset();
  publisher_.publish(sylph_msgs::JointActions());
}

}  // namespace sylph_planner_node
