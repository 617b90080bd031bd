#pragma once

#include <string>

namespace sylph_ros {

/// What an operator's command asks of a node.
struct TriggerCommand {
  std::string name;       ///< of the command, before what it says
  std::string service;    ///< std_srvs/Trigger, in the present namespace
  std::string server;     ///< who serves it, for the message that nobody does
  std::string if_silent;  ///< what the operator should do if the service does not answer
};

/// Calls a service from the shell, without a Python message on this computer. After ros::init().
/// @return exit status: 0 it is done, 1 with one line why not
int runTriggerCommand(const TriggerCommand& command);

}  // namespace sylph_ros
