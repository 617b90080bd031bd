#include "sylph_core/adg/schedule.hpp"

#include <algorithm>

namespace sylph {

Schedule computeSchedule(const ActionDependencyGraph& graph) {
  const std::vector<Task>& tasks = graph.tasks();
  // Longest chain that ends with a task, and longest that begins behind it.
  std::vector<int> length_to(tasks.size(), 1);
  std::vector<int> length_behind(tasks.size(), 0);
  Schedule schedule;
  // Ids sort the graph topologically, so that one pass in their order is enough, and one back.
  for (const Task& task : tasks) {
    int& length = length_to[static_cast<std::size_t>(task.id)];
    for (const TaskId before : graph.dependencies(task.id)) {
      length = std::max(length, length_to[static_cast<std::size_t>(before)] + 1);
    }
    schedule.critical_path = std::max(schedule.critical_path, length);
  }
  schedule.slack.assign(static_cast<std::size_t>(graph.agentCount()), schedule.critical_path);
  for (auto task = tasks.rbegin(); task != tasks.rend(); ++task) {
    const int behind = length_behind[static_cast<std::size_t>(task->id)];
    for (const TaskId before : graph.dependencies(task->id)) {
      int& length = length_behind[static_cast<std::size_t>(before)];
      length = std::max(length, behind + 1);
    }
    int& slack = schedule.slack[static_cast<std::size_t>(task->agent)];
    slack = std::min(
        slack, schedule.critical_path - behind - length_to[static_cast<std::size_t>(task->id)]);
  }
  return schedule;
}

}  // namespace sylph
