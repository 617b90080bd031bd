#include "sylph_core/benchmark/run_outcome.hpp"

namespace sylph {

std::string toString(RunOutcome outcome) {
  switch (outcome) {
    case RunOutcome::Solved:
      return toString(Outcome::Solved);
    case RunOutcome::TimeLimit:
      return toString(Outcome::TimeLimit);
    case RunOutcome::StepLimit:
      return toString(Outcome::StepLimit);
    case RunOutcome::Unsolvable:
      return toString(Outcome::Unsolvable);
    case RunOutcome::NoSolution:
      return "no solution";
    case RunOutcome::Invalid:
      return "invalid";
    case RunOutcome::Failed:
      return "failed";
  }
  return "unknown";
}

RunOutcome toRunOutcome(Outcome outcome) {
  switch (outcome) {
    case Outcome::Solved:
      return RunOutcome::Solved;
    case Outcome::TimeLimit:
      return RunOutcome::TimeLimit;
    case Outcome::StepLimit:
      return RunOutcome::StepLimit;
    case Outcome::Unsolvable:
      break;
  }
  return RunOutcome::Unsolvable;
}

}  // namespace sylph
