#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/adg/mission_plan.hpp"
#include "sylph_core/adg/task.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph {

enum class ExecutionPhase : std::uint8_t {
  Idle = 0,       ///< no plan
  Receiving = 1,  ///< a plan arrives, or waits until it may start
  Executing = 2,
  Cutting = 3,   ///< robots run to the commit cut, for a new plan from there
  AtCut = 4,     ///< all at the cut: waiting for the plan that replaces this one
  Finished = 5,  ///< every robot that is not lost has done all its tasks
  Refused = 6,   ///< the plan cannot be executed
};

enum class ExecutionMode : std::uint8_t {
  Run = 0,
  Pause = 1,  ///< no new task is released, robots finish those that they have
  Stop = 2,   ///< robots ramp to zero at once
};

enum class RobotCondition : std::uint8_t {
  Ok = 0,
  Silent = 1,  ///< no report for longer than the limit
  Stuck = 2,   ///< no progress for longer than the limit
  Blind = 3,   ///< reports that it has no good pose
  Lost = 4,    ///< out of the mission; its cells stay held
};

enum class ReportState : std::uint8_t { Idle = 0, Moving = 1, Holding = 2, Blind = 3 };

/// What a robot tells of itself: its whole state, so that a lost or doubled report does no harm.
struct RobotReport {
  std::uint32_t report_id = 0;  ///< counts up
  double stamp_s = 0.0;         ///< when measured, by the robot's clock [s]
  std::uint32_t plan_id = 0;    ///< plan of the counts below; 0: none yet
  int accepted = 0;             ///< tasks of the plan received without a gap
  int done = 0;                 ///< tasks of the plan done by measured arrival
  ReportState state = ReportState::Idle;
  std::string detail;             ///< why it holds or is blind
  std::optional<Point> position;  ///< measured [m]; nothing if it is not a number
  double tracking_error_m = 0.0;
  double pose_age_s = 0.0;
};

/// When something counts as wrong. Times in seconds of the caller's steady clock.
struct ExecutionLimits {
  int lookahead = 5;              ///< tasks that a robot may have ahead, > 0
  double resend_after_s = 0.3;    ///< a task that is not accepted is sent again, > 0
  double silent_after_s = 1.0;    ///< > 0
  double stuck_after_s = 5.0;     ///< > 0
  double lost_after_s = 0.0;      ///< trouble for so long makes a robot lost; 0: never by itself
  double start_wait_s = 60.0;     ///< a plan waits so long for robots to rest and report, > 0
  double progress_m = 0.02;       ///< a robot that moves so far makes progress, > 0
  double start_offset_m = 0.035;  ///< a robot may stand so far off the centre of its start, > 0
};

/// A task as it goes to its robot.
struct TaskOrder {
  int robot = 0;
  std::uint32_t plan_id = 0;
  int sequence = 0;     ///< the robot's k-th task of this plan, from 0
  int robot_tasks = 0;  ///< tasks of the robot in this plan
  Task task;
  TaskStatus status = TaskStatus::Enqueued;  ///< Enqueued or Done
  std::vector<TaskId> dependencies;
};

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

/// What is known of one robot, for people and messages.
struct RobotView {
  RobotCondition condition = RobotCondition::Ok;
  ReportState report_state = ReportState::Idle;
  int tasks_total = 0;  ///< of this plan
  int tasks_done = 0;   ///< of this plan
  Timestep step = 0;    ///< of this plan, to look up its social state
  std::optional<Task> task;
  TaskStatus task_status = TaskStatus::Staged;
  Cell cell;
  Cell goal;
  std::vector<Cell> held_cells;
  std::vector<Cell> remaining_path;
  std::string partner;
  float svo_deg = 0.0F;
  std::string waits_for_robot;  ///< empty: it does not wait
  TaskId waits_for_task = 0;
  Cell waits_for_cell;
  double waiting_since_s = 0.0;  ///< for how long [s]
  std::string root_cause_robot;
  std::string root_cause;
};

std::string toString(ExecutionPhase phase);
std::string toString(ExecutionMode mode);
std::string toString(RobotCondition condition);

}  // namespace sylph
