#pragma once

#include <ros/node_handle.h>

#include <string>

#include "sylph_core/files/range.hpp"

/// Single parameters that a node shares with others, such as those of its fleet; its own ones are
/// read by a ParameterReader. All throw std::runtime_error with one line: the parameter's full
/// name, what is allowed.
namespace sylph_ros {

/// Reads a parameter if it is set and leaves the default if not.
/// @throws std::runtime_error if it is set to another type, or out of range
void read(const ros::NodeHandle& nh, const std::string& name, double& value,
          const sylph::Range& range);
void read(const ros::NodeHandle& nh, const std::string& name, int& value,
          const sylph::Range& range);
void read(const ros::NodeHandle& nh, const std::string& name, bool& value);
void read(const ros::NodeHandle& nh, const std::string& name, std::string& value);

/// @throws std::runtime_error if the parameter is not set or of another type
std::string readRequiredString(const ros::NodeHandle& nh, const std::string& name);

}  // namespace sylph_ros
