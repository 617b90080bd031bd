#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/execution/task_order.hpp"
#include "sylph_core/grid/cell.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// What a robot makes of one task message.
enum class TaskVerdict {
  Accepted,  ///< new, and next in order
  Repeated,  ///< known already
  Early,     ///< comes after a gap, or belongs to a plan that cannot begin yet: will be sent again
  Late,      ///< of an old plan
  Refused,   ///< contradicts the map, the robot's place or what it was told before
};

/// The verdict on a task, and why.
struct TaskAnswer {
  TaskVerdict verdict;
  std::string reason;  ///< for the operator; empty if Accepted or Repeated
};

/// Where a robot is when it is offered a task.
struct Whereabouts {
  std::optional<Cell> cell;  ///< measured; nothing without a good pose
  /// It stands outside the cells that its tasks hold, or nobody carries their plan out any more.
  bool is_released = false;
};

/// The tasks that a robot has accepted and done, each exactly once and in order, whatever is lost,
/// doubled or late on the way.
///
/// Tasks count per plan. A plan with a greater id begins when all accepted tasks of the one before
/// are done, in the cell where these ended or where the robot is measured; or when they bind the
/// robot no more, in the cell where it stands.
class TaskQueue {
 public:
  explicit TaskQueue(Grid grid) : grid_(std::move(grid)) {}

  /// Takes a task if it is the next one, keeps it if it is early.
  TaskAnswer offer(const TaskOrder& task, const Whereabouts& whereabouts);

  /// Marks the current task done.
  /// @throws std::logic_error if there is none
  void completeCurrent();

  std::uint32_t planId() const { return plan_id_; }  ///< 0: none yet
  /// Tasks of this plan that have come without a gap.
  int accepted() const { return static_cast<int>(tasks_.size()); }
  /// Tasks of this plan that ended with a measured arrival.
  int done() const { return done_; }
  bool isIdle() const { return done_ == accepted(); }

  /// Accepted tasks of this plan by sequence.
  const std::vector<TaskOrder>& tasks() const { return tasks_; }
  /// The first task that is not done.
  std::optional<TaskOrder> current() const;
  /// Cells that the robot may be in: both of the current task, or the end of the last one. Empty
  /// before the first task.
  std::vector<Cell> heldCells() const;

 private:
  TaskAnswer offerOfThisPlan(const TaskOrder& task);
  TaskAnswer offerOfNewPlan(const TaskOrder& task, const Whereabouts& whereabouts);
  std::optional<std::string> contradictionOf(const TaskOrder& task) const;
  void accept(const TaskOrder& task);

  Grid grid_;
  std::uint32_t plan_id_ = 0;
  std::vector<TaskOrder> tasks_;
  int done_ = 0;
  std::map<int, TaskOrder> waiting_;  // of this plan, behind a gap, by sequence
};

}  // namespace sylph
