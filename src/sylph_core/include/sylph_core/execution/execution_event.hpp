#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/execution/states.hpp"

namespace sylph {

/// What an entry of the event log tells. Robots are indices.
namespace event {

/// `plan` is carried out from now on.
struct Started {
  std::shared_ptr<const MissionPlan> plan;  ///< with its id, which the entry has, too
};
/// A plan does not start, and why: for the operator, in one line.
struct Refused {
  std::string reason;
};
/// The plan gives way to a new mission: nothing more of it is released.
struct Abandoned {};
/// A task may be sent to its robot; what may be carried out is decided here, once.
struct Released {
  int robot = 0;
  int sequence = 0;  ///< of the task within the plan
};
/// The robot has confirmed that tasks have come.
struct Accepted {
  int robot = 0;
  int count = 0;  ///< tasks of the plan that it has without a gap
};
/// The robot has measured its arrival at the end of a task.
struct Done {
  int robot = 0;
  int sequence = 0;  ///< of the task within the plan
};
/// What the watchdogs think of a robot has changed.
struct Condition {
  int robot = 0;
  RobotCondition condition = RobotCondition::Ok;
  std::string reason;
};
/// The robot is out of the mission; its cells stay held.
struct Lost {
  int robot = 0;
  std::string reason;
};
/// The operator or the separation monitor lets robots run, pause or stop.
struct Mode {
  ExecutionMode mode = ExecutionMode::Run;
  std::string reason;
};
/// How far the plan is.
struct Phase {
  ExecutionPhase phase = ExecutionPhase::Idle;
};

}  // namespace event

/// One entry of the event log. The entries of a run, replayed in order, give the same state.
struct ExecutionEvent {
  using What = std::variant<event::Started, event::Refused, event::Abandoned, event::Released,
                            event::Accepted, event::Done, event::Condition, event::Lost,
                            event::Mode, event::Phase>;

  /// Not inline: where g++ 12 sees a variant made and moved at once, it warns of strings that are
  /// not there.
  ExecutionEvent(std::uint32_t of_plan, What told);

  std::uint32_t plan_id;  ///< 0: before any plan
  What what;
};

}  // namespace sylph
