#include "sylph_planner_node/mission_messages.hpp"

#include "sylph_ros/same_constants.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::ExecuteMissionResult;
using sylph_ros::isSame;

static_assert(isSame(sylph::MissionOutcome::Success, ExecuteMissionResult::SUCCESS) &&
              isSame(sylph::MissionOutcome::BadRequest, ExecuteMissionResult::BAD_REQUEST) &&
              isSame(sylph::MissionOutcome::NoPose, ExecuteMissionResult::NO_POSE) &&
              isSame(sylph::MissionOutcome::NoPlan, ExecuteMissionResult::NO_PLAN) &&
              isSame(sylph::MissionOutcome::PlanRefused, ExecuteMissionResult::PLAN_REFUSED) &&
              isSame(sylph::MissionOutcome::Preempted, ExecuteMissionResult::PREEMPTED) &&
              isSame(sylph::MissionOutcome::Incomplete, ExecuteMissionResult::INCOMPLETE));

}  // namespace

sylph_msgs::ExecuteMissionFeedback toMessage(const sylph::MissionProgress& progress) {
  sylph_msgs::ExecuteMissionFeedback message;
  message.phase = progress.phase;
  message.tasks_done = progress.tasks_done;
  message.tasks_total = progress.tasks_total;
  message.robots_arrived = progress.robots_arrived;
  message.waiting = progress.waiting;
  return message;
}

ExecuteMissionResult toMessage(const sylph::MissionResult& result) {
  ExecuteMissionResult message;
  message.outcome = static_cast<std::uint8_t>(result.outcome);
  message.message = result.message;
  message.robots = result.robots;
  message.arrived = result.arrived;
  message.plan_steps = result.plan_steps;
  message.sum_of_costs = result.sum_of_costs;
  message.planning_s = result.planning_s;
  message.execution_s = result.execution_s;
  message.replans = result.replans;
  return message;
}

}  // namespace sylph_planner_node
