#pragma once

#include <sylph_msgs/JointAction.h>

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_planner_node/checked_plan.hpp"

namespace sylph_planner_node {

/// What the messages of one plan have in common.
struct PlanIdentity {
  std::uint32_t plan_id = 0;           ///< greater than that of any earlier plan
  std::uint32_t replaces_plan_id = 0;  ///< 0: a new mission
  std::string planner;
};

/// The stream of messages of a plan, one per timestep. A plan of one configuration is one message
/// with steps 0 and STAY actions.
/// @param robots  name of each agent
std::vector<sylph_msgs::JointAction> toJointActions(const CheckedPlan& plan,
                                                    const std::vector<std::string>& robots,
                                                    const PlanIdentity& identity);

}  // namespace sylph_planner_node
