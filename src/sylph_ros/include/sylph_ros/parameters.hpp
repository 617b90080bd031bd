#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

/// Reading parameters so that a mistake is an error and never silence. All throw std::runtime_error
/// with one line: the parameter's full name, its value, what is allowed.
namespace sylph_ros {

/// Reads a parameter if it is set and leaves the default if not.
/// @throws std::runtime_error if it is set to another type
void read(const ros::NodeHandle& nh, const std::string& name, double& value);
void read(const ros::NodeHandle& nh, const std::string& name, int& value);
void read(const ros::NodeHandle& nh, const std::string& name, bool& value);
void read(const ros::NodeHandle& nh, const std::string& name, std::string& value);
void read(const ros::NodeHandle& nh, const std::string& name, std::vector<std::string>& value);

/// @throws std::runtime_error if the parameter is not set or of another type
std::string readRequiredString(const ros::NodeHandle& nh, const std::string& name);

/// @throws std::runtime_error unless value > 0 and finite
void requirePositive(const ros::NodeHandle& nh, const std::string& name, double value);
/// @throws std::runtime_error unless low <= value <= high
void requireInRange(const ros::NodeHandle& nh, const std::string& name, double value, double low,
                    double high);
/// @throws std::runtime_error if a parameter below `nh` is not among `known`: a typo is not silence
void requireKnown(const ros::NodeHandle& nh, const std::vector<std::string>& known);

}  // namespace sylph_ros
