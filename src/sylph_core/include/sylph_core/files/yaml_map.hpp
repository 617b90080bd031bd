#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/grid/cell.hpp"

namespace sylph {

/// Numbers that a field accepts: from `lowest` up to and with `highest`.
struct Range {
  double lowest = -std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::max();
  bool open_below = false;  ///< whether `lowest` itself is refused

  static Range positive() { return {0.0, std::numeric_limits<double>::max(), true}; }
  static Range atLeast(double lowest) { return {lowest}; }
};

/// A mapping in a YAML file, read strictly.
///
/// Each look-up throws std::runtime_error with one line, "file:line: field: what is wrong, what is
/// allowed", if the key is missing and has no default, or if its value is of the wrong type or out
/// of range.
class YamlMap {
 public:
  /// Reads a file whose whole content is one mapping.
  static YamlMap load(const std::string& path);

  /// Refuses keys that are not in the list and keys given twice, so that a typo is not silence.
  void requireOnly(const std::vector<std::string>& allowed) const;

  bool has(const std::string& key) const;

  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& otherwise) const;
  /// One of the given words.
  std::string word(const std::string& key, const std::vector<std::string>& allowed,
                   const std::string& otherwise) const;
  bool boolean(const std::string& key, bool otherwise) const;
  double number(const std::string& key, const Range& range) const;
  double number(const std::string& key, double otherwise, const Range& range) const;
  std::int64_t integer(const std::string& key, std::int64_t lowest, std::int64_t highest) const;
  std::int64_t integer(const std::string& key, std::int64_t otherwise, std::int64_t lowest,
                       std::int64_t highest) const;
  /// Exactly `count` numbers.
  std::vector<double> numbers(const std::string& key, std::size_t count, const Range& range) const;
  /// One or more whole numbers.
  std::vector<int> integers(const std::string& key, int lowest, int highest) const;
  /// One or more texts.
  std::vector<std::string> texts(const std::string& key) const;
  /// One or more of the given words.
  std::vector<std::string> words(const std::string& key,
                                 const std::vector<std::string>& allowed) const;
  /// [row, col], whole numbers; whether it lies on the map is for the caller to check.
  Cell cell(const std::string& key) const;
  /// A mapping below this one, none if the key is missing.
  std::optional<YamlMap> map(const std::string& key) const;
  /// One or more mappings.
  std::vector<YamlMap> maps(const std::string& key) const;

  /// An error in a field of this mapping, in the form of those above.
  std::runtime_error error(const std::string& key, const std::string& what) const;

  const std::string& path() const { return path_; }

 private:
  YamlMap(std::string path, std::string prefix, const YAML::Node& node);

  YAML::Node find(const std::string& key) const;
  YAML::Node require(const std::string& key) const;
  std::vector<YAML::Node> sequence(const std::string& key) const;
  double toNumber(const std::string& key, const YAML::Node& node, const Range& range) const;
  std::int64_t toInteger(const std::string& key, const YAML::Node& node, std::int64_t lowest,
                         std::int64_t highest) const;
  std::runtime_error errorAt(const YAML::Node& node, const std::string& key,
                             const std::string& what) const;

  std::string path_;
  std::string prefix_;  // of fields, such as "robots[2]."
  YAML::Node node_;
};

}  // namespace sylph
