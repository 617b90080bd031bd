#include "sylph_core/control/task_queue.hpp"

#include <algorithm>
#include <stdexcept>

#include "sylph_core/grid/action.hpp"

namespace sylph {
namespace {

// Against a sender that counts wrongly; messages that overtake each other are a few.
constexpr std::size_t kMostWaiting = 64;

std::string nameOf(const TaskOrder& task) {
  return "task " + std::to_string(task.sequence) + " of plan " + std::to_string(task.plan_id) +
         " from " + toString(task.start) + " to " + toString(task.end);
}

}  // namespace

TaskAnswer TaskQueue::offer(const TaskOrder& task, const Whereabouts& whereabouts) {
  if (task.plan_id == 0) {
    return {TaskVerdict::Refused, nameOf(task) + ": plans count from 1"};
  }
  if (task.plan_id < plan_id_) {
    return {TaskVerdict::Late, nameOf(task) + ": plan " + std::to_string(plan_id_) + " runs"};
  }
  if (!grid_.isFree(task.start) || !grid_.isFree(task.end)) {
    return {TaskVerdict::Refused, nameOf(task) + ": not a free cell of the map"};
  }
  if (manhattanDistance(task.start, task.end) != 1) {
    return {TaskVerdict::Refused, nameOf(task) + ": the cells are not adjacent"};
  }
  return task.plan_id == plan_id_ ? offerOfThisPlan(task) : offerOfNewPlan(task, whereabouts);
}

TaskAnswer TaskQueue::offerOfThisPlan(const TaskOrder& task) {
  const auto sequence = static_cast<std::size_t>(task.sequence);
  if (sequence < tasks_.size()) {
    // Sent again, since its confirmation was late; anything else under this number is an error at
    // the other end.
    if (!isSameTask(tasks_[sequence], task)) {
      return {TaskVerdict::Refused, nameOf(task) + ": was " + nameOf(tasks_[sequence])};
    }
    return {TaskVerdict::Repeated, ""};
  }
  if (sequence > tasks_.size()) {
    if (waiting_.size() < kMostWaiting) {
      waiting_.emplace(task.sequence, task);
    }
    return {TaskVerdict::Early, nameOf(task) + ": " + std::to_string(tasks_.size()) + " is next"};
  }
  if (const auto contradiction = contradictionOf(task)) {
    return {TaskVerdict::Refused, *contradiction};
  }
  accept(task);
  for (auto next = waiting_.find(accepted());
       next != waiting_.end() && !contradictionOf(next->second); next = waiting_.find(accepted())) {
    accept(next->second);
    waiting_.erase(next);
  }
  return {TaskVerdict::Accepted, ""};
}

TaskAnswer TaskQueue::offerOfNewPlan(const TaskOrder& task, const Whereabouts& whereabouts) {
  if (task.sequence != 0) {
    return {TaskVerdict::Early, nameOf(task) + ": the plan's first task is missing"};
  }
  // Tasks that are done are told to a node that was started again, so that it knows what it has
  // done.
  if (task.status != TaskStatus::Done) {
    if (!isIdle() && !whereabouts.is_released) {
      return {TaskVerdict::Early,
              nameOf(task) + ": plan " + std::to_string(plan_id_) + " is not done"};
    }
    const bool follows = isIdle() && !tasks_.empty() && tasks_.back().end == task.start;
    if (!follows && !whereabouts.cell) {
      return {TaskVerdict::Early, nameOf(task) + ": no good pose yet"};
    }
    // A node that starts again may find its robot between the cells of the first task.
    const bool is_there = whereabouts.cell && (*whereabouts.cell == task.start ||
                                               (plan_id_ == 0 && *whereabouts.cell == task.end));
    if (!follows && !is_there) {
      return {TaskVerdict::Refused,
              nameOf(task) + ": the robot is in " + toString(*whereabouts.cell)};
    }
  }
  plan_id_ = task.plan_id;
  tasks_.clear();
  waiting_.clear();
  done_ = 0;
  accept(task);
  return {TaskVerdict::Accepted, ""};
}

std::optional<std::string> TaskQueue::contradictionOf(const TaskOrder& task) const {
  if (!tasks_.empty() && tasks_.back().end != task.start) {
    return nameOf(task) + ": the one before ends in " + toString(tasks_.back().end);
  }
  if (task.status == TaskStatus::Done && !isIdle()) {
    return nameOf(task) + ": told to be done, but the one before is not";
  }
  return std::nullopt;
}

void TaskQueue::accept(const TaskOrder& task) {
  tasks_.push_back(task);
  if (task.status == TaskStatus::Done) {
    ++done_;
  }
}

void TaskQueue::completeCurrent() {
  if (isIdle()) {
    throw std::logic_error("no task to complete");
  }
  ++done_;
}

std::optional<TaskOrder> TaskQueue::current() const {
  if (isIdle()) {
    return std::nullopt;
  }
  return tasks_[static_cast<std::size_t>(done_)];
}

std::vector<Cell> TaskQueue::heldCells() const {
  if (tasks_.empty()) {
    return {};
  }
  if (const auto task = current()) {
    return {task->start, task->end};
  }
  return {tasks_.back().end};
}

}  // namespace sylph
