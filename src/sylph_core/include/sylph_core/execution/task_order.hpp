#pragma once

#include <cstdint>
#include <vector>

#include "sylph_core/execution/task.hpp"

namespace sylph {

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

}  // namespace sylph
