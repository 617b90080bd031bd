#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sylph_core/execution/mission_plan.hpp"

namespace sylph {

/// One entry of the event log. The entries of a run, replayed in order, give the same state.
struct ExecutionEvent {
  enum class Kind {
    Started,    ///< `plan` is carried out from now on
    Refused,    ///< plan_id, text: why
    Abandoned,  ///< plan_id gives way to a new mission: nothing more of it is released
    Released,   ///< robot, plan_id, number: sequence of the task
    Accepted,   ///< robot, plan_id, number: tasks that it has without a gap
    Done,       ///< robot, plan_id, number: sequence of the task
    Condition,  ///< robot, number: RobotCondition, text: why
    Lost,       ///< robot, text: by whom
    Mode,       ///< number: ExecutionMode, text: by whom or why
    Phase,      ///< number: ExecutionPhase
  };
  Kind kind = Kind::Phase;
  std::uint32_t plan_id = 0;
  int robot = -1;  ///< index, -1: none
  int number = 0;
  std::string text;
  std::shared_ptr<const MissionPlan> plan = nullptr;
};

}  // namespace sylph
