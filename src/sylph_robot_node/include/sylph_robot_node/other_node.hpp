#pragma once

namespace sylph_robot_node {

/// Waits until no other node of this name drives the robot, and says so in one line. ROS itself
/// ends the older of two nodes with one name; roslaunch starts that again, which ends the other,
/// and so on.
///
/// To be called before the first node handle, which makes the name known.
void waitForOtherNode();

}  // namespace sylph_robot_node
