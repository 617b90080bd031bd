#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sylph_core/execution/states.hpp"
#include "sylph_core/execution/task.hpp"

namespace sylph {

/// What is known of one robot, for people and messages.
struct RobotView {
  RobotCondition condition = RobotCondition::Ok;
  RobotState report_state = RobotState::Idle;
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
  double waited_s = 0.0;  ///< for how long [s]
  std::string root_cause_robot;
  std::string root_cause;
};

}  // namespace sylph
