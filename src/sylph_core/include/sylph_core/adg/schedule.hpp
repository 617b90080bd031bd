#pragma once

#include <vector>

#include "sylph_core/adg/action_dependency_graph.hpp"

namespace sylph {

/// How long the moves of a graph take if each takes one unit and starts as early as it may.
struct Schedule {
  int critical_path = 0;  ///< the longest chain of dependent tasks [cells]
  std::vector<int>
      slack;  ///< per agent: delay of all its tasks that costs the whole nothing [cells]
};

/// Counts all tasks, done or not. An agent without tasks has all of the critical path as slack.
Schedule computeSchedule(const ActionDependencyGraph& graph);

}  // namespace sylph
