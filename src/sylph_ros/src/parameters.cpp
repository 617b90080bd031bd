#include "sylph_ros/parameters.hpp"

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

void requireWithin(const ros::NodeHandle& nh, const std::string& name, double value,
                   const sylph::Range& range) {
  if (!range.contains(value)) {
    throw std::runtime_error("parameter " + nh.resolveName(name) + " = " +
                             sylph::shortNumber(value) + ": must be " + sylph::toString(range));
  }
}

}  // namespace

void read(const ros::NodeHandle& nh, const std::string& name, double& value,
          const sylph::Range& range) {
  readAs(nh, name, value, "a number");
  requireWithin(nh, name, value, range);
}

void read(const ros::NodeHandle& nh, const std::string& name, int& value,
          const sylph::Range& range) {
  readAs(nh, name, value, "a whole number");
  requireWithin(nh, name, value, range);
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

std::string readRequiredString(const ros::NodeHandle& nh, const std::string& name) {
  std::string value;
  read(nh, name, value);
  if (value.empty()) {
    throw std::runtime_error("parameter " + nh.resolveName(name) + ": must be set");
  }
  return value;
}

}  // namespace sylph_ros
