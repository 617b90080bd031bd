#pragma once

namespace sylph_robot_node {

/// From now on SIGINT and SIGTERM only set a flag. roscpp's own handler closes the publishers at
/// once, and a base that latches its last command would drive on. To be called after ros::start(),
/// which installs that handler.
void catchShutdownSignals();

/// Whether such a signal has come.
bool isShutdownRequested();

}  // namespace sylph_robot_node
