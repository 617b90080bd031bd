#include "sylph_core/execution/robot_report.hpp"

#include <tuple>

namespace sylph {

bool tellTheSame(const RobotReport& a, const RobotReport& b) {
  return std::tie(a.state, a.plan_id, a.accepted, a.done) ==
         std::tie(b.state, b.plan_id, b.accepted, b.done);
}

}  // namespace sylph
