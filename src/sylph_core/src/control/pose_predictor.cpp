#include "sylph_core/control/pose_predictor.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sylph {
namespace {

// Several seconds of commands: far more than poses are ever old before the robot stops for that.
constexpr std::size_t kMemory = 500;

struct Step {
  double distance;  // moved
  double rate;      // at the end
};

/// First-order lag of one axis: from rate `v` under command `u` for `dt_s`.
/// @param decay  exp(-dt / lag)
Step follow(double v, double u, double dt_s, double lag_s, double decay) {
  if (lag_s <= 0.0) {
    return {u * dt_s, u};
  }
  return {u * dt_s + (v - u) * lag_s * (1.0 - decay), u + (v - u) * decay};
}

/// Moves `state` on under a constant command; the yaw is not normalized.
void advance(MotionState& state, const Twist2d& command_map, double dt_s, double lag_s) {
  const double decay = lag_s > 0.0 ? std::exp(-dt_s / lag_s) : 0.0;
  const Step x = follow(state.twist_map.x_mps, command_map.x_mps, dt_s, lag_s, decay);
  const Step y = follow(state.twist_map.y_mps, command_map.y_mps, dt_s, lag_s, decay);
  const Step yaw = follow(state.twist_map.turn_radps, command_map.turn_radps, dt_s, lag_s, decay);
  state.pose.x_m += x.distance;
  state.pose.y_m += y.distance;
  state.pose.yaw_rad += yaw.distance;
  state.twist_map = {x.rate, y.rate, yaw.rate};
}

bool isSame(const Twist2d& a, const Twist2d& b) {
  return a.x_mps == b.x_mps && a.y_mps == b.y_mps && a.turn_radps == b.turn_radps;
}

}  // namespace

PosePredictor::PosePredictor(const BaseModel& model) : model_(model) {
  if (!(std::isfinite(model.latency_s) && model.latency_s >= 0.0 && std::isfinite(model.lag_s) &&
        model.lag_s >= 0.0)) {
    throw std::invalid_argument("latency and lag of a base: must be >= 0");
  }
  if (!(model.timeout_s > 0.0)) {
    throw std::invalid_argument("timeout of a base: must be > 0");
  }
}

void PosePredictor::command(double time_s, const Twist2d& twist_map) {
  const double effective_s = time_s + model_.latency_s;
  // A base that heard nothing for so long has stopped by itself in the meantime.
  if (!commands_.empty() && timedOut() < effective_s) {
    append(timedOut(), {});
  }
  append(effective_s, twist_map);
  sent_s_ = time_s;
}

void PosePredictor::append(double effective_s, const Twist2d& twist_map) {
  MotionState before;
  if (!commands_.empty()) {
    const Command& last = commands_.back();
    if (isSame(last.twist_map, twist_map)) {
      return;  // it goes on: a robot that waits without a pose fills no memory
    }
    before.twist_map = last.before_map;
    advance(before, last.twist_map, effective_s - last.effective_s, model_.lag_s);
  }
  commands_.push_back({effective_s, twist_map, before.twist_map});
  if (commands_.size() > kMemory) {
    commands_.pop_front();
  }
}

void PosePredictor::forgetBefore(double time_s) {
  while (commands_.size() > 1 && commands_[1].effective_s < time_s) {
    commands_.pop_front();
  }
}

MotionState PosePredictor::predict(const Pose2d& captured, double captured_s, double time_s) const {
  MotionState state;
  state.pose = captured;
  if (commands_.empty()) {
    return state;
  }
  // What was over before the capture has left its trace in the velocity of what came after it.
  std::size_t first = commands_.size() - 1;
  while (first > 0 && commands_[first].effective_s > std::min(captured_s, time_s)) {
    --first;
  }
  state.twist_map = commands_[first].before_map;
  const auto pass = [&](const Twist2d& twist_map, double begin_s, double end_s) {
    // Before the capture only the velocity builds up; the pose is known.
    const double known_until_s = std::clamp(captured_s, begin_s, std::max(begin_s, end_s));
    if (known_until_s > begin_s) {
      MotionState before = state;
      advance(before, twist_map, known_until_s - begin_s, model_.lag_s);
      state.twist_map = before.twist_map;
    }
    if (end_s > known_until_s) {
      advance(state, twist_map, end_s - known_until_s, model_.lag_s);
    }
  };
  for (std::size_t i = first; i < commands_.size(); ++i) {
    const double over_s = i + 1 < commands_.size() ? commands_[i + 1].effective_s : timedOut();
    pass(commands_[i].twist_map, commands_[i].effective_s, std::min(over_s, time_s));
  }
  if (timedOut() < time_s) {
    pass({}, timedOut(), time_s);
  }
  state.pose.yaw_rad = normalizeAngle(state.pose.yaw_rad);
  return state;
}

}  // namespace sylph
