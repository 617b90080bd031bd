#include "sylph_planner_node/joint_actions.hpp"

#include <algorithm>
#include <limits>

#include "sylph_core/grid/action.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

sylph_msgs::AgentAction toAgentAction(const sylph::Cell& from, const sylph::Cell& to) {
  sylph_msgs::AgentAction message;
  // checkPlan() has seen to it that the cells are equal or adjacent.
  message.action = sylph_ros::toMessage(sylph::actionBetween(from, to).value());
  message.from = sylph_ros::toMessage(from);
  message.to = sylph_ros::toMessage(to);
  return message;
}

}  // namespace

std::vector<sylph_msgs::JointAction> toJointActions(const CheckedPlan& plan,
                                                    const std::vector<std::string>& robots,
                                                    const PlanIdentity& identity) {
  const std::size_t steps = plan.plan.size() - 1;
  std::vector<sylph_msgs::JointAction> messages;
  for (std::size_t step = 0; step < std::max<std::size_t>(steps, 1); ++step) {
    sylph_msgs::JointAction message;
    message.header.frame_id = sylph_ros::kMapFrame;
    message.plan_id = identity.plan_id;
    message.replaces_plan_id = identity.replaces_plan_id;
    message.planner = identity.planner;
    message.planning_s = plan.planning_s;
    message.step = static_cast<std::uint32_t>(step);
    message.steps = static_cast<std::uint32_t>(steps);
    const sylph::Configuration& from = plan.plan[step];
    const sylph::Configuration& to = plan.plan[std::min(step + 1, steps)];
    for (std::size_t agent = 0; agent < robots.size(); ++agent) {
      sylph_msgs::AgentAction action = toAgentAction(from[agent], to[agent]);
      action.robot = robots[agent];
      action.goal = sylph_ros::toMessage(plan.instance.goals[agent]);
      action.svo_deg = std::numeric_limits<float>::quiet_NaN();
      if (step < plan.social.size()) {
        const auto partner = static_cast<std::size_t>(plan.social[step].partners[agent]);
        action.partner = partner == agent ? std::string() : robots.at(partner);
        action.svo_deg = plan.social[step].svo_deg[agent];
      }
      message.agents.push_back(action);
    }
    messages.push_back(message);
  }
  return messages;
}

}  // namespace sylph_planner_node
