#include "sylph_adg_central/plan_assembler.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sylph_ros/conversions.hpp"

namespace sylph_adg_central {
namespace {

using sylph_msgs::AgentAction;
using sylph_msgs::JointAction;

[[noreturn]] void refuse(const JointAction& message, const std::string& what) {
  throw std::invalid_argument("step " + std::to_string(message.step) + ": " + what);
}

void requireWellFormed(const JointAction& message) {
  if (message.steps > PlanAssembler::kMaxSteps) {
    refuse(message, std::to_string(message.steps) + " steps are more than " +
                        std::to_string(PlanAssembler::kMaxSteps));
  }
  if (message.step >= std::max(message.steps, 1U)) {
    refuse(message, "the plan has only " + std::to_string(message.steps) + " steps");
  }
  if (message.agents.empty()) {
    refuse(message, "it names no robots");
  }
  for (const AgentAction& agent : message.agents) {
    const auto action = sylph_ros::actionFromMessage(agent.action);
    if (!action || (message.steps == 0 && *action != sylph::Action::Stay) ||
        sylph::neighbor(sylph_ros::fromMessage(agent.from), *action) !=
            sylph_ros::fromMessage(agent.to)) {
      refuse(message, "action " + std::to_string(agent.action) + " of " + agent.robot +
                          " does not lead from " +
                          sylph::toString(sylph_ros::fromMessage(agent.from)) + " to " +
                          sylph::toString(sylph_ros::fromMessage(agent.to)));
    }
  }
}

/// The partner's index among the agents; without one, its own.
sylph::AgentId partnerOf(const JointAction& message, std::size_t agent) {
  const std::string& partner = message.agents[agent].partner;
  const auto found = std::find_if(message.agents.begin(), message.agents.end(),
                                  [&](const AgentAction& other) { return other.robot == partner; });
  return found == message.agents.end()
             ? static_cast<sylph::AgentId>(agent)
             : static_cast<sylph::AgentId>(found - message.agents.begin());
}

}  // namespace

std::optional<sylph::MissionPlan> PlanAssembler::add(const JointAction& message) {
  if (message.plan_id < plan_id_ || (message.plan_id == plan_id_ && is_over_)) {
    return std::nullopt;
  }
  if (message.plan_id > plan_id_) {
    begin(message);
  }
  try {
    requireWellFormed(message);
    requireConsistent(message);
  } catch (const std::invalid_argument&) {
    is_over_ = true;
    messages_.clear();
    throw;
  }
  if (messages_.empty()) {
    messages_.resize(std::max(steps_, 1U));
  }
  std::optional<JointAction>& slot = messages_[message.step];
  if (slot) {
    return std::nullopt;
  }
  slot = message;
  ++received_;
  if (received_ < messages_.size()) {
    return std::nullopt;
  }
  is_over_ = true;
  sylph::MissionPlan plan = assemble();
  messages_.clear();
  return plan;
}

void PlanAssembler::begin(const JointAction& message) {
  plan_id_ = message.plan_id;
  steps_ = message.steps;
  received_ = 0;
  is_over_ = false;
  messages_.clear();
}

void PlanAssembler::requireConsistent(const JointAction& message) const {
  if (message.steps != steps_) {
    refuse(message, std::to_string(message.steps) + " steps, but " + std::to_string(steps_) +
                        " in another message of the plan");
  }
  const auto isNeighbour = [&](std::size_t step) {
    return step < messages_.size() && messages_[step].has_value();
  };
  for (const std::size_t step : {std::size_t{message.step} + 1, std::size_t{message.step} - 1}) {
    if (!isNeighbour(step)) {
      continue;
    }
    const JointAction& other = *messages_[step];
    const bool is_next = step > message.step;
    if (other.agents.size() != message.agents.size() ||
        other.replaces_plan_id != message.replaces_plan_id) {
      refuse(message, "robots or replaces_plan_id differ from step " + std::to_string(step));
    }
    for (std::size_t agent = 0; agent < message.agents.size(); ++agent) {
      const AgentAction& mine = message.agents[agent];
      const AgentAction& theirs = other.agents[agent];
      const sylph_msgs::Cell& end = is_next ? mine.to : theirs.to;
      const sylph_msgs::Cell& start = is_next ? theirs.from : mine.from;
      if (mine.robot != theirs.robot ||
          sylph_ros::fromMessage(end) != sylph_ros::fromMessage(start)) {
        refuse(message, mine.robot + " does not go on where it is in step " + std::to_string(step));
      }
    }
  }
}

sylph::MissionPlan PlanAssembler::assemble() const {
  const JointAction& first = *messages_.front();
  sylph::MissionPlan plan;
  plan.plan_id = plan_id_;
  plan.replaces_plan_id = first.replaces_plan_id;
  plan.planner = first.planner;
  plan.planning_s = first.planning_s;
  plan.plan.resize(1);
  for (const AgentAction& agent : first.agents) {
    plan.robots.push_back(agent.robot);
    plan.goals.push_back(sylph_ros::fromMessage(agent.goal));
    plan.plan.front().push_back(sylph_ros::fromMessage(agent.from));
  }
  for (std::uint32_t step = 0; step < steps_; ++step) {
    const JointAction& message = *messages_[step];
    sylph::Configuration cells;
    sylph::SocialState social;
    for (std::size_t agent = 0; agent < message.agents.size(); ++agent) {
      cells.push_back(sylph_ros::fromMessage(message.agents[agent].to));
      social.partners.push_back(partnerOf(message, agent));
      social.svo_deg.push_back(message.agents[agent].svo_deg);
    }
    plan.plan.push_back(std::move(cells));
    plan.social.push_back(std::move(social));
  }
  return plan;
}

}  // namespace sylph_adg_central
