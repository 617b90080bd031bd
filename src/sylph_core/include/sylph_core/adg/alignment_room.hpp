#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph {

/// A robot that may be aligned, and where all others rest.
struct AlignmentQuestion {
  std::size_t robot = 0;
  std::vector<std::optional<Pose2d>> poses;  ///< of each robot; nothing where none is known
  Pose2d target;                             ///< middle of the robot's cell and its heading
  /// Whether it is under way: then half the clearance does, so that noise does not stop it.
  bool is_under_way = false;
};

/// Why a robot has no room to turn where it stands and then to drive straight to its target, to
/// follow its name; nothing if it has. Looks at each degree and each 4 mm of the way.
std::optional<std::string> reasonNotToAlign(const AlignmentQuestion& question,
                                            const std::vector<std::string>& names,
                                            const CellFrame& frame, const AlignmentLimits& limits);

}  // namespace sylph
