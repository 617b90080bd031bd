#pragma once

#include <sylph_msgs/JointAction.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "sylph_core/execution/mission_plan.hpp"

namespace sylph_adg_central {

/// Puts the messages of a plan together, in whatever order and how often they come. A message of a
/// newer plan than the one that is being put together begins that one; one of an older is ignored.
class PlanAssembler {
 public:
  /// @return the plan once it is complete, and then never again
  /// @throws std::invalid_argument with one line if the message is malformed or contradicts others
  /// of its plan, which is then given up
  std::optional<sylph::MissionPlan> add(const sylph_msgs::JointAction& message);

  /// The plan that is being put together or was put together last; 0: none yet.
  std::uint32_t planId() const { return plan_id_; }
  std::uint32_t steps() const { return steps_; }
  std::uint32_t stepsReceived() const { return received_; }

  static constexpr std::uint32_t kMaxSteps = 1000000;

 private:
  void begin(const sylph_msgs::JointAction& message);
  void requireConsistent(const sylph_msgs::JointAction& message) const;
  sylph::MissionPlan assemble() const;

  std::uint32_t plan_id_ = 0;
  std::uint32_t steps_ = 0;
  std::uint32_t received_ = 0;
  bool is_over_ = true;                                           ///< complete, or given up
  std::vector<std::optional<sylph_msgs::JointAction>> messages_;  ///< by step; one if steps_ is 0
};

}  // namespace sylph_adg_central
