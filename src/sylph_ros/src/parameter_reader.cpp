#include "sylph_ros/parameter_reader.hpp"

#include <algorithm>
#include <sstream>

#include "sylph_core/text/join.hpp"

namespace sylph_ros {
namespace {

using XmlRpc::XmlRpcValue;

std::string inQuotes(const std::string& text) {
  return "\"" + text + "\"";
}

std::string shown(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<const bool&>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<const int&>(value));
    case XmlRpcValue::TypeDouble:
      return sylph::shortNumber(static_cast<const double&>(value));
    case XmlRpcValue::TypeString:
      return inQuotes(value);
    case XmlRpcValue::TypeArray:
      return "a list";
    case XmlRpcValue::TypeStruct:
      return "a group of parameters";
    default:
      return "something";
  }
}

XmlRpcValue valuesOf(const ros::NodeHandle& nh) {
  XmlRpcValue values;
  nh.getParam(nh.getNamespace(), values);
  return values;
}

}  // namespace

std::optional<std::string> textOf(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeString:
      return static_cast<const std::string&>(value);
    case XmlRpcValue::TypeInt:
      return shown(value);
    case XmlRpcValue::TypeDouble: {
      const std::string text = shown(value);
      const bool is_whole = text.find_first_not_of("-0123456789") == std::string::npos;
      return text + (is_whole ? ".0" : "");
    }
    default:
      return std::nullopt;
  }
}

ParameterReader::ParameterReader() : ParameterReader("~", {}) {}

ParameterReader::ParameterReader(const ros::NodeHandle& nh)
    : ParameterReader(nh.getNamespace(), valuesOf(nh)) {}

ParameterReader::ParameterReader(const std::string& name_space, const XmlRpcValue& values)
    : name_space_(name_space + "/"), asked_(std::make_shared<std::vector<Parameter>>()) {
  if (values.getType() == XmlRpcValue::TypeStruct) {
    values_ = values;
  }
}

ParameterReader::ParameterReader(const ParameterReader& parent, const std::string& name)
    : name_space_(parent.name_space_), prefix_(parent.prefix_ + name + "/"), asked_(parent.asked_) {
  if (parent.values_.valid() && parent.values_.hasMember(name)) {
    values_ = parent.values_[name];
    if (values_.getType() != XmlRpcValue::TypeStruct) {
      throw parent.error(name, "must be a group of parameters");
    }
  }
}

void ParameterReader::read(const std::string& name, double& value, const sylph::Range& range,
                           const std::string& meaning) {
  const std::string allowed = sylph::toString(range);
  if (const auto* found = find(name, sylph::shortNumber(value), allowed, meaning)) {
    if (found->getType() == XmlRpcValue::TypeInt) {
      value = static_cast<const int&>(*found);
    } else if (found->getType() == XmlRpcValue::TypeDouble) {
      value = static_cast<const double&>(*found);
    } else {
      throw error(name, "must be a number");
    }
    if (!range.contains(value)) {
      throw error(name, "must be " + allowed);
    }
  }
}

void ParameterReader::read(const std::string& name, int& value, const sylph::Range& range,
                           const std::string& meaning) {
  const std::string allowed = sylph::toString(range);
  if (const auto* found = find(name, std::to_string(value), allowed, meaning)) {
    if (found->getType() != XmlRpcValue::TypeInt) {
      throw error(name, "must be a whole number");
    }
    value = static_cast<const int&>(*found);
    if (!range.contains(value)) {
      throw error(name, "must be " + allowed);
    }
  }
}

void ParameterReader::read(const std::string& name, bool& value, const std::string& meaning) {
  if (const auto* found = find(name, value ? "true" : "false", "true, false", meaning)) {
    if (found->getType() != XmlRpcValue::TypeBoolean) {
      throw error(name, "must be true or false");
    }
    value = static_cast<const bool&>(*found);
  }
}

void ParameterReader::read(const std::string& name, std::string& value,
                           const std::string& meaning) {
  if (const auto* found = find(name, inQuotes(value), "", meaning)) {
    const std::optional<std::string> text = textOf(*found);
    if (!text) {
      throw error(name, "must be a text");
    }
    value = *text;
  }
}

std::size_t ParameterReader::readWord(const std::string& name,
                                      const std::vector<std::string>& words, std::size_t otherwise,
                                      const std::string& meaning) {
  const auto* found = find(name, inQuotes(words[otherwise]), sylph::join(words), meaning);
  if (found == nullptr) {
    return otherwise;
  }
  if (found->getType() == XmlRpcValue::TypeString) {
    const std::string& given = *found;
    const auto place = std::find(words.begin(), words.end(), given);
    if (place != words.end()) {
      return static_cast<std::size_t>(place - words.begin());
    }
  }
  throw error(name, "must be one of " + sylph::join(words));
}

XmlRpcValue ParameterReader::readList(const std::string& name, const std::string& meaning) {
  const auto* found = find(name, "[]", "a list", meaning);
  if (found == nullptr) {
    return {};
  }
  if (found->getType() != XmlRpcValue::TypeArray) {
    throw error(name, "must be a list");
  }
  return *found;
}

ParameterReader ParameterReader::group(const std::string& name) const {
  return {*this, name};
}

const XmlRpcValue* ParameterReader::find(const std::string& name, const std::string& otherwise,
                                         const std::string& allowed, const std::string& meaning) {
  asked_->push_back({prefix_ + name, otherwise, allowed, meaning});
  return values_.valid() && values_.hasMember(name) ? &values_[name] : nullptr;
}

void ParameterReader::refuseUnread() const {
  if (values_.valid()) {
    refuseUnread(values_, prefix_);
  }
}

void ParameterReader::refuseUnread(const XmlRpcValue& values, const std::string& prefix) const {
  for (const auto& [name, value] : values) {
    const std::string path = prefix + name;
    bool is_read = false;
    bool is_group = false;
    std::vector<std::string> siblings;
    for (const Parameter& parameter : *asked_) {
      is_read = is_read || parameter.name == path;
      is_group = is_group || parameter.name.rfind(path + "/", 0) == 0;
      if (parameter.name.rfind(prefix, 0) == 0) {
        const std::string rest = parameter.name.substr(prefix.size());
        const std::string sibling = rest.substr(0, rest.find('/'));
        if (std::find(siblings.begin(), siblings.end(), sibling) == siblings.end()) {
          siblings.push_back(sibling);
        }
      }
    }
    if (is_group && value.getType() == XmlRpcValue::TypeStruct) {
      refuseUnread(value, path + "/");
    } else if (!is_read) {
      throw std::runtime_error("parameter " + name_space_ + path + ": unknown; allowed are " +
                               sylph::join(siblings));
    }
  }
}

std::runtime_error ParameterReader::error(const std::string& name, const std::string& what) const {
  std::string text = "parameter " + name_space_ + prefix_ + name;
  if (values_.valid() && values_.hasMember(name)) {
    text += " = " + shown(values_[name]);
  }
  return std::runtime_error(text + ": " + what);
}

std::string ParameterReader::table() const {
  std::ostringstream rows;
  for (const Parameter& parameter : *asked_) {
    rows << "| `" << parameter.name << "` | " << parameter.otherwise << " | " << parameter.allowed
         << " | " << parameter.meaning << " |\n";
  }
  return rows.str();
}

void readDiagnosticPeriod(ParameterReader& reader) {
  double period_s = 1.0;
  reader.read("diagnostic_period", period_s, sylph::Range::positive(),
              "seconds between two messages on `/diagnostics`");
}

}  // namespace sylph_ros
