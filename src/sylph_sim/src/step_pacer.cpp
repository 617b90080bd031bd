#include "sylph_sim/step_pacer.hpp"

#include <algorithm>
#include <cmath>

#include "sylph_sim/bounds.hpp"

namespace sylph_sim {

StepPacer::StepPacer(double step_s, double target_speed, double max_backlog_s)
    : step_s_(step_s),
      target_speed_(target_speed),
      max_backlog_s_(max_backlog_s),
      speed_(target_speed) {
  requireWithin("step_s", step_s, sylph::Range::positive());
  requireWithin("speed", target_speed, sylph::Range::positive());
  requireWithin("max_backlog_s", max_backlog_s, sylph::Range::positive());
}

int StepPacer::stepsDue(double wall_s) {
  if (!origin_wall_s_) {
    origin_wall_s_ = wall_s;
    window_wall_s_ = wall_s;
    return 0;
  }
  const double steps_per_wall_s = target_speed_ / step_s_;
  // The small share keeps a wall clock that ticks in whole steps from being one step late.
  const auto target =
      static_cast<std::int64_t>(std::floor((wall_s - *origin_wall_s_) * steps_per_wall_s + 1e-6));
  const auto limit = std::max<std::int64_t>(1, std::llround(max_backlog_s_ / step_s_));
  std::int64_t due = std::max<std::int64_t>(0, target - steps_);
  if (due > limit) {
    due = limit;
    origin_wall_s_ = wall_s;
    steps_ = 0;
  } else {
    steps_ += due;
  }
  measure(wall_s, static_cast<int>(due));
  return static_cast<int>(due);
}

void StepPacer::measure(double wall_s, int due) {
  window_steps_ += due;
  const double elapsed_s = wall_s - window_wall_s_;
  if (elapsed_s >= 1.0) {
    speed_ = static_cast<double>(window_steps_) * step_s_ / elapsed_s;
    window_wall_s_ = wall_s;
    window_steps_ = 0;
  }
}

}  // namespace sylph_sim
