#include "sylph_core/control/alignment.hpp"

#include <cmath>

namespace sylph {
namespace {

constexpr double kSpeed_mps = 0.03;
// Of what is commanded, latency, lag and slip leave so much without an answer.
constexpr double kUnanswered_m = 0.02;
constexpr double kUnanswered_rad = 0.26;  // 15 deg

}  // namespace

Alignment::Alignment(const Point& target, const Pose2d& from, double heading_rad,
                     double heading_tolerance_rad)
    : target_(target),
      heading_rad_(heading_rad),
      heading_tolerance_rad_(heading_tolerance_rad),
      to_go_m_(distanceFrom(from)),
      to_go_rad_(angleFrom(from)) {}

double Alignment::angleFrom(const Pose2d& pose) const {
  return std::abs(shortestAngle(pose.yaw_rad, heading_rad_));
}

Twist2d Alignment::limit(const Twist2d& wanted_map, const Pose2d& pose, double duration_s) {
  const double limit_mps = angleFrom(pose) > heading_tolerance_rad_ ? 0.0 : kSpeed_mps;
  const double wanted_mps = speed(wanted_map);
  const double share = wanted_mps > limit_mps ? limit_mps / wanted_mps : 1.0;
  commanded_m_ += share * wanted_mps * duration_s;
  commanded_rad_ += std::abs(wanted_map.turn_radps) * duration_s;
  if (commanded_m_ - (to_go_m_ - distanceFrom(pose)) > kUnanswered_m ||
      commanded_rad_ - (to_go_rad_ - angleFrom(pose)) > kUnanswered_rad) {
    problem_ =
        "its pose does not follow while it is aligned: is its base dead, or are bodies exchanged?";
  }
  return {share * wanted_map.x_mps, share * wanted_map.y_mps, wanted_map.turn_radps};
}

}  // namespace sylph
