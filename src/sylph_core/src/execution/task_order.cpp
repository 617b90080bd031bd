#include "sylph_core/execution/task_order.hpp"

namespace sylph {

bool isSameTask(const TaskOrder& a, const TaskOrder& b) {
  return a.plan_id == b.plan_id && a.sequence == b.sequence && a.start == b.start && a.end == b.end;
}

}  // namespace sylph
