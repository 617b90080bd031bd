#include "sylph_core/adg/alignment_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

// A robot that is turned further has rather a body whose axes are wrong.
constexpr double kLargestTurn_rad = 0.785398163397448;  // 45 deg
constexpr double kTurnStep_rad = 0.0175;                // 1 deg
constexpr double kDriveStep_m = 0.004;
// The corners of a robot that is turned by 45 deg come a little nearer at first.
constexpr double kNearer_m = 0.002;

Footprint at(Footprint footprint, const Point& center, double yaw_rad) {
  footprint.center = center;
  footprint.yaw_rad = yaw_rad;
  return footprint;
}

int stepsOf(double length, double step) {
  return std::max(1, static_cast<int>(std::ceil(std::abs(length) / step)));
}

/// Where the robot is on its way: first it turns, then it drives.
std::vector<Footprint> wayOf(const Footprint& size, const Pose2d& from, const Pose2d& to) {
  std::vector<Footprint> way;
  const double turn_rad = shortestAngle(from.yaw_rad, to.yaw_rad);
  const int turns = stepsOf(turn_rad, kTurnStep_rad);
  for (int k = 0; k <= turns; ++k) {
    way.push_back(at(size, position(from), from.yaw_rad + turn_rad * k / turns));
  }
  const Vector2 drive = displacement(position(from), position(to));
  const int drives = stepsOf(norm(drive), kDriveStep_m);
  for (int k = 1; k <= drives; ++k) {
    way.push_back(at(size, position(from) + (1.0 * k / drives) * drive, to.yaw_rad));
  }
  return way;
}

/// A gap to what is at rest: where the robot stands, and the smallest one on its way [m].
struct Gaps {
  double at_first_m = std::numeric_limits<double>::infinity();
  double smallest_m = std::numeric_limits<double>::infinity();
};

Gaps gapsTo(const Footprint& other, const std::vector<Footprint>& way) {
  Gaps gaps;
  gaps.at_first_m = footprintGap(way.front(), other);
  for (const Footprint& robot : way) {
    gaps.smallest_m = std::min(gaps.smallest_m, footprintGap(robot, other));
  }
  return gaps;
}

/// @param least_m  gap that does if the robot comes no nearer than it stands
bool isRoom(const Gaps& gaps, double clearance_m, double least_m) {
  const bool comes_no_nearer = gaps.smallest_m >= gaps.at_first_m - kNearer_m;
  return gaps.smallest_m >= clearance_m || (comes_no_nearer && gaps.smallest_m >= least_m);
}

std::string reasonOf(const Gaps& gaps, const std::string& other, double clearance_m) {
  return format("would come within %.0f mm of ", gaps.smallest_m * 1e3) + other +
         format(" while it is aligned: at least %.0f are needed", clearance_m * 1e3);
}

}  // namespace

std::optional<std::string> reasonNotToAlign(const AlignmentQuestion& question,
                                            const std::vector<std::string>& names,
                                            const CellFrame& frame, const AlignmentLimits& limits) {
  const Pose2d& from = question.poses.at(question.robot).value();
  const double turn_rad = shortestAngle(from.yaw_rad, question.target.yaw_rad);
  if (std::abs(turn_rad) > kLargestTurn_rad) {
    return format("is turned by %.0f deg, and at most ", std::abs(turn_rad) * 180.0 / M_PI) +
           format("%.0f are aligned: turn it by hand", kLargestTurn_rad * 180.0 / M_PI);
  }
  const Footprint& size = limits.footprints.at(question.robot);
  const std::vector<Footprint> way = wayOf(size, from, question.target);
  const double least_m = 0.5 * limits.clearance_m;
  const double clearance_m = question.is_under_way ? least_m : limits.clearance_m;
  for (std::size_t other = 0; other < question.poses.size(); ++other) {
    if (other == question.robot || !question.poses[other]) {
      continue;
    }
    const Pose2d& pose = *question.poses[other];
    const Footprint robot = at(limits.footprints[other], position(pose), pose.yaw_rad);
    if (const Gaps gaps = gapsTo(robot, way); !isRoom(gaps, clearance_m, least_m)) {
      return reasonOf(gaps, names[other], clearance_m);
    }
  }
  // To one obstacle it may come nearer, along another one that is as near.
  Gaps nearest;
  Cell nearest_cell;
  const double around_m = std::hypot(size.length_m, size.width_m) / 2.0 + clearance_m +
                          distance(position(from), position(question.target));
  for (const Cell& cell : frame.cellsUnder(position(from), {around_m, around_m})) {
    if (limits.obstacles.isFree(cell)) {
      continue;
    }
    const Gaps gaps = gapsTo({frame.toPoint(cell), 0.0, frame.cellSize(), frame.cellSize()}, way);
    nearest.at_first_m = std::min(nearest.at_first_m, gaps.at_first_m);
    if (gaps.smallest_m < nearest.smallest_m) {
      nearest.smallest_m = gaps.smallest_m;
      nearest_cell = cell;
    }
  }
  return isRoom(nearest, clearance_m, 0.0)
             ? std::nullopt
             : std::make_optional(
                   reasonOf(nearest, "the obstacle at " + toString(nearest_cell), clearance_m));
}

}  // namespace sylph
