#include "joint_search.hpp"

#include <functional>
#include <queue>
#include <set>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/mapf/check_plan.hpp"

namespace sylph {
namespace {

bool isLegalStep(const Configuration& from, const Configuration& to, bool rotations) {
  for (std::size_t a = 0; a < from.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (to[a] == to[b] || (to[a] == from[b] && to[b] == from[a])) {
        return false;
      }
    }
  }
  return rotations || findRotations(from, to).empty();
}

void forEachStep(const Grid& grid, const Configuration& from, Configuration& to,
                 const std::function<void()>& visit) {
  const std::size_t agent = to.size();
  if (agent == from.size()) {
    visit();
    return;
  }
  for (const Action action : kActions) {
    if (grid.isFree(neighbor(from[agent], action))) {
      to.push_back(neighbor(from[agent], action));
      forEachStep(grid, from, to, visit);
      to.pop_back();
    }
  }
}

}  // namespace

bool isSolvableByJointSearch(const Instance& instance) {
  std::set<Configuration> seen = {instance.starts};
  std::queue<Configuration> open({instance.starts});
  while (!open.empty()) {
    const Configuration from = open.front();
    open.pop();
    if (from == instance.goals) {
      return true;
    }
    Configuration to;
    forEachStep(instance.grid, from, to, [&] {
      if (isLegalStep(from, to, instance.motion.rotations) && seen.insert(to).second) {
        open.push(to);
      }
    });
  }
  return false;
}

}  // namespace sylph
