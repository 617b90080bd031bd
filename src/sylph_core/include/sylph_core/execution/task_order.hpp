#pragma once

#include <cstdint>
#include <vector>

#include "sylph_core/execution/task.hpp"

namespace sylph {

/// A task as it goes to its robot.
struct TaskOrder {
  std::uint32_t plan_id = 0;  ///< from 1
  int sequence = 0;           ///< the robot's k-th task of this plan, from 0
  Cell start;
  Cell end;
  /// Enqueued: to be carried out. Done: to be counted only, by a node that was started again.
  TaskStatus status = TaskStatus::Enqueued;
  int robot = 0;                          ///< index of the robot at the central node
  int robot_tasks = 0;                    ///< tasks of the robot in this plan
  TaskId task_id = 0;                     ///< in the graph of the plan; see `dependencies`
  Timestep timestep = 0;                  ///< scheduled in the plan
  std::vector<TaskId> dependencies = {};  ///< ids in the plan's graph
};

/// Whether two orders are of the same task, whatever has become of it.
bool isSameTask(const TaskOrder& a, const TaskOrder& b);

}  // namespace sylph
