#include "sylph_core/execution/states.hpp"

namespace sylph {

std::string toString(ExecutionPhase phase) {
  switch (phase) {
    case ExecutionPhase::Idle:
      return "idle";
    case ExecutionPhase::Pending:
      return "pending";
    case ExecutionPhase::Executing:
      return "executing";
    case ExecutionPhase::Cutting:
      return "cutting";
    case ExecutionPhase::AtCut:
      return "at the cut";
    case ExecutionPhase::Finished:
      return "finished";
    case ExecutionPhase::Refused:
      return "refused";
  }
  return "unknown";
}

std::string toString(ExecutionMode mode) {
  switch (mode) {
    case ExecutionMode::Run:
      return "run";
    case ExecutionMode::Pause:
      return "pause";
    case ExecutionMode::Stop:
      return "stop";
  }
  return "unknown";
}

std::string toString(RobotCondition condition) {
  switch (condition) {
    case RobotCondition::Ok:
      return "ok";
    case RobotCondition::Silent:
      return "silent";
    case RobotCondition::Stuck:
      return "stuck";
    case RobotCondition::Blind:
      return "blind";
    case RobotCondition::Lost:
      return "lost";
  }
  return "unknown";
}

}  // namespace sylph
