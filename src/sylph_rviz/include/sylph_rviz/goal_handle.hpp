#pragma once

#include <std_msgs/ColorRGBA.h>

#include <optional>
#include <string>

#include "sylph_core/geometry/vector2.hpp"

namespace sylph_rviz {

/// What there is of one robot to click and to drag.
struct GoalHandle {
  std::string robot;                 ///< its name and its tf frame
  double length_m = 0.0;             ///< of its footprint, > 0
  double width_m = 0.0;              ///< of its footprint, > 0
  std_msgs::ColorRGBA color;         ///< of the handle
  std::optional<sylph::Point> goal;  ///< where its handle is; nothing: goals cannot be dragged
  bool is_on_robot = false;          ///< the handle lies on the robot, and is clicked in its place
};

/// What an operator does with the mouse.
struct GoalEvent {
  /// In the order in which they come: a drag begins with Select and ends with Drop.
  enum class Kind {
    Select,  ///< a click on a robot or on its handle
    Drag,    ///< the handle is being moved
    Drop     ///< the handle is let go
  };
  Kind kind = Kind::Select;
  std::string robot;   ///< its name
  sylph::Point point;  ///< of Drag and Drop, in frame `map` [m]
};

}  // namespace sylph_rviz
