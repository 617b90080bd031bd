#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/files/range.hpp"

namespace sylph_ros {

/// A parameter as a text: YAML makes a number of a text that looks like one, such as the version
/// 3.0 without quotes.
/// @return nothing if it is neither text nor number
std::optional<std::string> textOf(const XmlRpc::XmlRpcValue& value);

/// The parameters of one node, read strictly: what is set has to have the right type and to lie
/// within its bounds, and what nobody has asked for is refused.
///
/// A parameter stands once in the code, in the call that reads it: its name (with the unit), its
/// default (the value that is passed in), its bounds, its meaning. README tables and shipped YAML
/// come from these calls: see table().
///
/// Errors are std::runtime_error with one line: the full name, the value, what is allowed.
class ParameterReader {
 public:
  /// Nothing is set: all keeps its default. Needs no ROS master.
  ParameterReader();
  /// What is set below the handle's namespace now.
  explicit ParameterReader(const ros::NodeHandle& nh);
  /// @param values  a struct; of another type if nothing is set
  ParameterReader(const std::string& name_space, const XmlRpc::XmlRpcValue& values);

  /// Reads a parameter into `value` if it is set, and leaves the default if not.
  void read(const std::string& name, double& value, const sylph::Range& range,
            const std::string& meaning);
  void read(const std::string& name, int& value, const sylph::Range& range,
            const std::string& meaning);
  void read(const std::string& name, bool& value, const std::string& meaning);
  /// A number is taken for the text that it looks like.
  void read(const std::string& name, std::string& value, const std::string& meaning);

  /// One of a few words; a default that is not among them cannot be.
  template <typename Value>
  void readChoice(const std::string& name, Value& value,
                  const std::vector<std::pair<std::string, Value>>& choices,
                  const std::string& meaning) {
    std::vector<std::string> words;
    std::size_t chosen = 0;
    for (const auto& [word, meant] : choices) {
      chosen = meant == value ? words.size() : chosen;
      words.push_back(word);
    }
    value = choices[readWord(name, words, chosen, meaning)].second;
  }

  /// A text that stands for a value, such as an address; an empty one leaves the value as it is.
  /// @param otherwise  the text that stands for the default
  /// @param parse      text -> Value, throws std::exception that says what is allowed
  template <typename Value, typename Parse>
  void readParsed(const std::string& name, Value& value, std::string otherwise, const Parse& parse,
                  const std::string& meaning) {
    read(name, otherwise, meaning);
    if (otherwise.empty()) {
      return;
    }
    try {
      value = parse(otherwise);
    } catch (const std::exception& failure) {
      throw error(name, failure.what());
    }
  }

  /// A list of whatever form, left unset (of type Invalid) if it is not set.
  XmlRpc::XmlRpcValue readList(const std::string& name, const std::string& meaning);

  /// Parameters below this one: `base` has `base/wheel_lag_s`.
  ParameterReader group(const std::string& name) const;

  /// Refuses what is set and was not asked for, so that a typo is not silence.
  void refuseUnread() const;

  /// An error in a parameter: its full name, its value if one is set, and what is wrong with it.
  std::runtime_error error(const std::string& name, const std::string& what) const;

  /// What was asked for, in that order, as rows of a Markdown table:
  /// "| `name` | default | allowed | meaning |". Defaults are YAML.
  std::string table() const;

 private:
  struct Parameter {
    std::string name;
    std::string otherwise;
    std::string allowed;
    std::string meaning;
  };

  ParameterReader(const ParameterReader& parent, const std::string& name);

  /// Remembers the question; nothing if the parameter is not set.
  const XmlRpc::XmlRpcValue* find(const std::string& name, const std::string& otherwise,
                                  const std::string& allowed, const std::string& meaning);
  std::size_t readWord(const std::string& name, const std::vector<std::string>& words,
                       std::size_t otherwise, const std::string& meaning);
  void refuseUnread(const XmlRpc::XmlRpcValue& values, const std::string& prefix) const;

  std::string name_space_;                         // "/sylph/sylph_planner/"
  std::string prefix_;                             // of a group: "base/"
  XmlRpc::XmlRpcValue values_;                     // a struct
  std::shared_ptr<std::vector<Parameter>> asked_;  // of the node, whatever group
};

/// The parameter that diagnostic_updater reads by itself in the namespace of its node.
void readDiagnosticPeriod(ParameterReader& reader);

/// Reads all parameters below the handle's namespace with `read(ParameterReader&)` and refuses the
/// rest.
template <typename Read>
auto readStrictly(const ros::NodeHandle& nh, const Read& read) {
  ParameterReader reader(nh);
  auto options = read(reader);
  reader.refuseUnread();
  return options;
}

}  // namespace sylph_ros
