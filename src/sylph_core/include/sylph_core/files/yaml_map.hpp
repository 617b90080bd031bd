#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "sylph_core/files/range.hpp"
#include "sylph_core/grid/cell.hpp"

namespace YAML {
class Node;
}

namespace sylph {

/// A mapping in a YAML file, read strictly.
///
/// It remembers which keys it was asked for, so that none has to be listed a second time: whoever
/// reads a mapping ends with refuseUnread().
///
/// Each look-up throws std::runtime_error with one line, "file:line: field: what is wrong, what is
/// allowed", if the key is missing and has no default, or if its value is of the wrong type or out
/// of range.
class YamlMap {
 public:
  /// Reads a file whose whole content is one mapping.
  static YamlMap load(const std::string& path);

  /// Refuses keys that nobody has asked for and keys given twice, so that a typo is not silence.
  void refuseUnread() const;

  /// Whether the key is there; it counts as asked for.
  bool has(const std::string& key) const;

  /// A text, not empty, as it stands in the file; `otherwise` if the key is missing.
  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& otherwise) const;
  /// One of the given words.
  std::string word(const std::string& key, const std::vector<std::string>& allowed,
                   const std::string& otherwise) const;
  /// `true` or `false`, or `otherwise` if the key is missing.
  bool boolean(const std::string& key, bool otherwise) const;
  /// A finite number within the range; `otherwise` if the key is missing.
  double number(const std::string& key, const Range& range) const;
  double number(const std::string& key, double otherwise, const Range& range) const;
  /// A whole number within the bounds; `otherwise` if the key is missing.
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

  /// The file, for messages.
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
  std::shared_ptr<const YAML::Node> node_;
  std::shared_ptr<std::vector<std::string>> asked_;  // keys, in the order of asking; of all copies
};

}  // namespace sylph
