#include "sylph_sim/cameras.hpp"

#include <algorithm>
#include <limits>

#include "sylph_sim/bounds.hpp"

namespace sylph_sim {
namespace {

sylph::Pose2d between(const sylph::Pose2d& before, const sylph::Pose2d& after, double share) {
  return {before.x_m + share * (after.x_m - before.x_m),
          before.y_m + share * (after.y_m - before.y_m),
          sylph::normalizeAngle(before.yaw_rad +
                                share * sylph::shortestAngle(before.yaw_rad, after.yaw_rad))};
}

}  // namespace

void visitNumbers(CameraOptions& options, const NumberVisitor& visit) {
  const sylph::Range not_negative = sylph::Range::atLeast(0.0);
  const sylph::Range probability{0.0, 1.0};
  visit("rate_hz", options.rate_hz, sylph::Range::positive(), "frames a simulated second");
  visit("latency_s", options.latency_s, not_negative, "from exposure to sending");
  visit("position_noise_m", options.position_noise_m, not_negative,
        "standard deviation an axis and frame");
  visit("yaw_noise_rad", options.yaw_noise_rad, not_negative, "standard deviation a frame");
  visit("body_offset_m", options.body_offset_m, not_negative,
        "standard deviation of a body's constant offset from its robot");
  visit("body_yaw_offset_rad", options.body_yaw_offset_rad, not_negative,
        "standard deviation of its constant rotation");
  visit("occlusion_probability", options.occlusion_probability, probability,
        "of a body not being tracked in a frame");
  visit("frame_loss_probability", options.frame_loss_probability, probability,
        "of a frame never being sent");
}

void requireValid(const CameraOptions& options) {
  requireNumbersWithin(options);
}

Cameras::Cameras(const CameraOptions& options, const std::vector<sylph::Pose2d>& poses,
                 double start_s, sylph::Rng rng)
    : options_(options), rng_(rng), last_s_(start_s), start_s_(start_s) {
  requireValid(options);
  // Clipped at 2.5 deviations: a marker set that is mounted worse than that would be seen.
  const auto draw = [this](double deviation) {
    return deviation * std::clamp(sylph::drawNormal(rng_), -2.5, 2.5);
  };
  for (const sylph::Pose2d& pose : poses) {
    const double x_m = draw(options_.body_offset_m);
    const double y_m = draw(options_.body_offset_m);
    robot_from_body_.push_back({x_m, y_m, draw(options_.body_yaw_offset_rad)});
    last_seen_.push_back(compose(pose, robot_from_body_.back()));
  }
}

void Cameras::capture(double time_s, const std::vector<sylph::Pose2d>& before,
                      const std::vector<sylph::Pose2d>& after, const FaultState& faults) {
  while (nextExposure() <= time_s) {
    const double exposure_s = nextExposure();
    CapturedFrame frame{next_number_++, exposure_s, exposure_s, {}};
    const double share = (exposure_s - last_s_) / (time_s - last_s_);
    std::vector<sylph::Pose2d> poses;
    poses.reserve(before.size());
    for (std::size_t robot = 0; robot < before.size(); ++robot) {
      poses.push_back(between(before[robot], after[robot], share));
    }
    for (std::size_t robot = 0; robot < poses.size(); ++robot) {
      frame.bodies.push_back(see(robot, poses, faults.robots[robot].capture));
    }
    // Drawn whether it matters or not: a fault must not shift the noise of what comes after it.
    const bool is_lost = sylph::drawFraction(rng_) < options_.frame_loss_probability;
    if (!is_lost && !faults.is_silent) {
      waiting_.push_back(std::move(frame));
    }
  }
  last_s_ = time_s;
}

std::vector<CapturedFrame> Cameras::takeDue(double time_s) {
  std::vector<CapturedFrame> due;
  while (!waiting_.empty() && waiting_.front().captured_s + options_.latency_s <= time_s) {
    due.push_back(std::move(waiting_.front()));
    due.back().sent_s = time_s;
    waiting_.pop_front();
  }
  return due;
}

CapturedBody Cameras::see(std::size_t robot, const std::vector<sylph::Pose2d>& poses,
                          const CaptureFault& fault) {
  CapturedBody body{compose(poses[fault.shown_robot], robot_from_body_[fault.shown_robot]), true};
  body.pose.x_m += options_.position_noise_m * sylph::drawNormal(rng_);
  body.pose.y_m += options_.position_noise_m * sylph::drawNormal(rng_);
  body.pose.yaw_rad += options_.yaw_noise_rad * sylph::drawNormal(rng_);
  if (fault.is_frozen) {
    body.pose = last_seen_[robot];
  }
  // A body is frozen before it jumps or turns, as faults may come together.
  last_seen_[robot] = body.pose;
  body.pose.x_m += fault.x_offset_m;
  body.pose.yaw_rad = sylph::normalizeAngle(body.pose.yaw_rad + fault.yaw_offset_rad);
  if (fault.is_nan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    body.pose = {nan, nan, nan};
  }
  body.is_tracked = !fault.is_lost && !(sylph::drawFraction(rng_) < options_.occlusion_probability);
  return body;
}

}  // namespace sylph_sim
