#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/execution/states.hpp"
#include "sylph_core/execution/task.hpp"

namespace sylph {

/// What the central node knows of one robot, see RobotExecution.msg.
struct RobotExecution {
  std::string robot;                              ///< its name
  RobotCondition condition = RobotCondition::Ok;  ///< as the central node's watchdogs see it
  RobotState report_state = RobotState::Idle;     ///< as the robot itself reports it
  int tasks_total = 0;                            ///< of this plan
  int tasks_done = 0;                             ///< of this plan
  Timestep step = 0;                              ///< of this plan, to look up its social state
  // The first task that is not done, if there is one.
  TaskId task_id = 0;
  TaskStatus task_status = TaskStatus::Staged;
  Action action = Action::Stay;
  Cell cell;                         ///< end of its last task done, or its start
  Cell next_cell;                    ///< end of that task, or `cell`
  Cell goal;                         ///< `cell` for a robot without part in the mission
  std::vector<Cell> held_cells;      ///< that nobody else may enter now
  std::vector<Cell> remaining_path;  ///< ends of the tasks that are not done, in order
  std::string partner;               ///< its name; empty without one
  float svo_deg = 0.0F;              ///< 0 (selfish) ... 45 (prosocial) [deg]
  std::string waits_for_robot;       ///< empty: it does not wait
  TaskId waits_for_task = 0;         ///< which has to be done first
  Cell waits_for_cell;               ///< which that task leaves
  double waited_s = 0.0;             ///< for how long [s]
  bool is_aligning = false;          ///< is to turn and drive to the middle of its cell
  std::string root_cause_robot;      ///< the last of those who wait for each other
  std::string root_cause;            ///< why that one does not go on, in one line
};

/// State of execution as it is told to operator, planner and robots, see AdgState.msg.
struct AdgState {
  std::uint32_t plan_id = 0;           ///< pending, carried out, or refused last; 0: none yet
  std::uint32_t last_plan_id = 0;      ///< the largest in plans and reports
  std::uint32_t executed_plan_id = 0;  ///< whose tasks robots may carry out; 0: of none
  ExecutionPhase phase = ExecutionPhase::Idle;
  ExecutionMode mode = ExecutionMode::Run;
  std::string message;                 ///< why the plan was refused, or why robots pause or stop
  std::uint32_t steps = 0;             ///< joint actions of the plan
  double elapsed_s = 0.0;              ///< since the first task was released
  std::vector<RobotExecution> robots;  ///< all of the lab, in the order of its experiment
};

}  // namespace sylph
