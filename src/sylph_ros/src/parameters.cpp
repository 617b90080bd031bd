#include "sylph_ros/parameters.hpp"

#include <XmlRpcValue.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sylph_ros/parameter_reader.hpp"

namespace sylph_ros {
namespace {

template <typename Value>
void readAs(const ros::NodeHandle& nh, const std::string& name, Value& value,
            const std::string& type) {
  // getParam() alone keeps the default and says nothing when the type is wrong.
  if (nh.hasParam(name) && !nh.getParam(name, value)) {
    throw std::runtime_error("parameter " + nh.resolveName(name) + ": must be " + type);
  }
}

[[noreturn]] void refuse(const ros::NodeHandle& nh, const std::string& name, double value,
                         const std::string& allowed) {
  throw std::runtime_error("parameter " + nh.resolveName(name) + " = " + std::to_string(value) +
                           ": must be " + allowed);
}

}  // namespace

void read(const ros::NodeHandle& nh, const std::string& name, double& value) {
  readAs(nh, name, value, "a number");
}
void read(const ros::NodeHandle& nh, const std::string& name, int& value) {
  readAs(nh, name, value, "a whole number");
}
void read(const ros::NodeHandle& nh, const std::string& name, bool& value) {
  readAs(nh, name, value, "true or false");
}
void read(const ros::NodeHandle& nh, const std::string& name, std::string& value) {
  XmlRpc::XmlRpcValue found;
  if (!nh.getParam(name, found)) {
    return;
  }
  const std::optional<std::string> text = textOf(found);
  if (!text) {
    throw std::runtime_error("parameter " + nh.resolveName(name) + ": must be a text");
  }
  value = *text;
}
void read(const ros::NodeHandle& nh, const std::string& name, std::vector<std::string>& value) {
  readAs(nh, name, value, "a list of texts");
}

std::string readRequiredString(const ros::NodeHandle& nh, const std::string& name) {
  std::string value;
  read(nh, name, value);
  if (value.empty()) {
    throw std::runtime_error("parameter " + nh.resolveName(name) + ": must be set");
  }
  return value;
}

void requirePositive(const ros::NodeHandle& nh, const std::string& name, double value) {
  if (!std::isfinite(value) || value <= 0.0) {
    refuse(nh, name, value, "> 0");
  }
}

void requireInRange(const ros::NodeHandle& nh, const std::string& name, double value, double low,
                    double high) {
  if (!(value >= low && value <= high)) {
    refuse(nh, name, value, "in " + std::to_string(low) + " ... " + std::to_string(high));
  }
}

void requireKnown(const ros::NodeHandle& nh, const std::vector<std::string>& known) {
  XmlRpc::XmlRpcValue parameters;
  if (!nh.getParam(nh.getNamespace(), parameters) ||
      parameters.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    return;
  }
  for (const auto& [name, value] : parameters) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::string allowed;
      for (const std::string& candidate : known) {
        allowed += (allowed.empty() ? "" : ", ") + candidate;
      }
      throw std::runtime_error("parameter " + nh.resolveName(name) + ": unknown; allowed are " +
                               allowed);
    }
  }
}

}  // namespace sylph_ros
