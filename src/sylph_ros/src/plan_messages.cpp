#include "sylph_ros/plan_messages.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_ros {
namespace {

using sylph_msgs::AgentAction;
using sylph_msgs::JointAction;
using sylph_msgs::JointActions;

void requireSize(std::size_t steps, std::size_t agents) {
  if (steps > kMaxActions / std::max<std::size_t>(agents, 1)) {
    throw std::invalid_argument("it has " + std::to_string(steps) + " steps of " +
                                std::to_string(agents) + " agents: a message holds at most " +
                                std::to_string(kMaxActions) + " actions");
  }
}

void requireCount(const std::string& what, std::size_t count, std::size_t agents) {
  if (count != agents) {
    throw std::invalid_argument(what + std::to_string(count) + ", but there are " +
                                std::to_string(agents) + " agents");
  }
}

sylph::Configuration toCells(const std::vector<sylph_msgs::Cell>& messages) {
  sylph::Configuration cells;
  for (const sylph_msgs::Cell& message : messages) {
    cells.push_back(fromMessage(message));
  }
  return cells;
}

AgentAction toAction(const sylph::MissionPlan& plan, std::size_t step, std::size_t agent) {
  const sylph::Cell& from = plan.plan[step].at(agent);
  const sylph::Cell& to = plan.plan[step + 1].at(agent);
  const sylph::SocialState& social = plan.social.at(step);
  const auto partner = static_cast<std::size_t>(social.partners.at(agent));
  AgentAction action;
  // Whoever sends a plan has checked it: the cells are equal or adjacent.
  action.action = toMessage(sylph::actionBetween(from, to).value());
  action.from = toMessage(from);
  action.to = toMessage(to);
  action.partner = partner == agent ? std::string() : plan.robots.at(partner);
  action.svo_deg = social.svo_deg.at(agent);
  return action;
}

void requireMove(const AgentAction& action, const std::string& agent, const sylph::Cell& cell) {
  const sylph::Cell from = fromMessage(action.from);
  const sylph::Cell to = fromMessage(action.to);
  if (from != cell) {
    throw std::invalid_argument(agent + " goes on from " + toString(from) + ", but it is in " +
                                toString(cell));
  }
  const auto known = actionFromMessage(action.action);
  if (!known || sylph::neighbor(from, *known) != to) {
    throw std::invalid_argument("action " + std::to_string(action.action) + " of " + agent +
                                " does not lead from " + toString(from) + " to " + toString(to));
  }
}

/// Adds one timestep to a plan.
void append(const JointAction& message, sylph::MissionPlan& plan) {
  requireCount("actions: ", message.actions.size(), plan.robots.size());
  sylph::Configuration cells;
  sylph::SocialState social;
  for (std::size_t agent = 0; agent < plan.robots.size(); ++agent) {
    const AgentAction& action = message.actions[agent];
    requireMove(action, plan.robots[agent], plan.plan.back()[agent]);
    const auto partner = std::find(plan.robots.begin(), plan.robots.end(), action.partner);
    const auto index = static_cast<std::size_t>(partner - plan.robots.begin());
    social.partners.push_back(
        static_cast<sylph::AgentId>(partner == plan.robots.end() ? agent : index));
    social.svo_deg.push_back(action.svo_deg);
    cells.push_back(fromMessage(action.to));
  }
  plan.plan.push_back(std::move(cells));
  plan.social.push_back(std::move(social));
}

}  // namespace

JointActions toMessage(const sylph::MissionPlan& plan) {
  requireSize(plan.steps(), plan.robots.size());
  JointActions message;
  message.header.frame_id = kMapFrame;
  message.plan_id = plan.plan_id;
  message.replaces_plan_id = plan.replaces_plan_id;
  message.first_step = plan.first_step;
  message.planner = plan.planner;
  message.planning_s = plan.planning_s;
  message.agents = plan.robots;
  message.starts = toMessage(plan.plan.at(0));
  message.goals = toMessage(plan.goals);
  message.steps.resize(plan.steps());
  for (std::size_t step = 0; step < message.steps.size(); ++step) {
    for (std::size_t agent = 0; agent < plan.robots.size(); ++agent) {
      message.steps[step].actions.push_back(toAction(plan, step, agent));
    }
  }
  return message;
}

sylph::MissionPlan fromMessage(const JointActions& message) {
  if (message.agents.empty()) {
    throw std::invalid_argument("it names no agents");
  }
  requireSize(message.steps.size(), message.agents.size());
  requireCount("starts: ", message.starts.size(), message.agents.size());
  requireCount("goals: ", message.goals.size(), message.agents.size());
  sylph::MissionPlan plan;
  plan.plan_id = message.plan_id;
  plan.replaces_plan_id = message.replaces_plan_id;
  plan.first_step = message.first_step;
  plan.planner = message.planner;
  plan.planning_s = message.planning_s;
  plan.robots = message.agents;
  plan.goals = toCells(message.goals);
  plan.plan = {toCells(message.starts)};
  for (std::size_t step = 0; step < message.steps.size(); ++step) {
    try {
      append(message.steps[step], plan);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("step " + std::to_string(step) + ": " + error.what());
    }
  }
  return plan;
}

}  // namespace sylph_ros
