#include "sylph_core/files/yaml_map.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "files/text_file.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph {
namespace {

// A file given by mistake, such as a bag, must not be parsed as YAML for minutes.
constexpr std::size_t kMaxYamlBytes = std::size_t{1} << 20;

std::size_t lineOf(const YAML::Mark& mark) {
  return mark.is_null() ? 0 : static_cast<std::size_t>(mark.line) + 1;
}

/// What stands there, for messages.
std::string shown(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return "is " + inQuotes(node.Scalar());
    case YAML::NodeType::Sequence:
      return "is a list";
    case YAML::NodeType::Map:
      return "is a mapping";
    default:
      return "is empty";
  }
}

/// Listens to a parser and keeps nothing.
class IgnoreEvents : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {}
  void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/,
                       YAML::anchor_t /*anchor*/, YAML::EmitterStyle::value /*style*/) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {}
  void OnMapEnd() override {}
};

/// Whether something stands behind the first document that YAML::Load() would pass over in
/// silence. (YAML::LoadAll() never comes back from a closing bracket there.)
bool hasMoreThanOneDocument(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  IgnoreEvents ignore;
  parser.HandleNextDocument(ignore);
  return parser.HandleNextDocument(ignore);
}

}  // namespace

YamlMap::YamlMap(std::string path, std::string prefix, const YAML::Node& node)
    : path_(std::move(path)),
      prefix_(std::move(prefix)),
      node_(std::make_shared<YAML::Node>(node)),
      asked_(std::make_shared<std::vector<std::string>>()) {}

YamlMap YamlMap::load(const std::string& path) {
  const std::string text = readTextFile(path, kMaxYamlBytes);
  try {
    const YAML::Node document = YAML::Load(text);
    if (document.IsNull()) {
      throw fileError(path, 0, "is empty, must be a YAML mapping");
    }
    if (!document.IsMap() || hasMoreThanOneDocument(text)) {
      throw fileError(path, 0, "must be one YAML mapping of 'key: value' lines");
    }
    return {path, "", document};
  } catch (const YAML::Exception& exception) {
    throw fileError(path, lineOf(exception.mark), "is not YAML: " + exception.msg);
  }
}

void YamlMap::refuseUnread() const {
  const std::vector<std::string>& allowed = *asked_;
  std::set<std::string> seen;
  for (const auto& entry : *node_) {
    if (!entry.first.IsScalar() ||
        std::find(allowed.begin(), allowed.end(), entry.first.Scalar()) == allowed.end()) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "(not a word)";
      throw fileError(path_, lineOf(entry.first.Mark()),
                      prefix_ + printable(key) + ": unknown key, must be one of " + join(allowed));
    }
    // yaml-cpp takes the first of two and says nothing.
    if (!seen.insert(entry.first.Scalar()).second) {
      throw fileError(path_, lineOf(entry.first.Mark()),
                      prefix_ + entry.first.Scalar() + ": given twice, must be given once");
    }
  }
}

bool YamlMap::has(const std::string& key) const {
  return find(key).IsDefined();
}

std::string YamlMap::text(const std::string& key) const {
  const YAML::Node node = require(key);
  if (!node.IsScalar() || node.Scalar().empty()) {
    throw errorAt(node, key, shown(node) + ", must be a text");
  }
  return node.Scalar();
}

std::string YamlMap::text(const std::string& key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

std::string YamlMap::word(const std::string& key, const std::vector<std::string>& allowed,
                          const std::string& otherwise) const {
  if (!has(key)) {
    return otherwise;
  }
  const YAML::Node node = require(key);
  if (!node.IsScalar() ||
      std::find(allowed.begin(), allowed.end(), node.Scalar()) == allowed.end()) {
    throw errorAt(node, key, shown(node) + ", must be one of " + join(allowed));
  }
  return node.Scalar();
}

bool YamlMap::boolean(const std::string& key, bool otherwise) const {
  return word(key, {"true", "false"}, otherwise ? "true" : "false") == "true";
}

double YamlMap::number(const std::string& key, const Range& range) const {
  return toNumber(key, require(key), range);
}

double YamlMap::number(const std::string& key, double otherwise, const Range& range) const {
  return has(key) ? number(key, range) : otherwise;
}

std::int64_t YamlMap::integer(const std::string& key, std::int64_t lowest,
                              std::int64_t highest) const {
  return toInteger(key, require(key), lowest, highest);
}

std::int64_t YamlMap::integer(const std::string& key, std::int64_t otherwise, std::int64_t lowest,
                              std::int64_t highest) const {
  return has(key) ? integer(key, lowest, highest) : otherwise;
}

std::vector<double> YamlMap::numbers(const std::string& key, std::size_t count,
                                     const Range& range) const {
  const std::vector<YAML::Node> nodes = sequence(key);
  if (nodes.size() != count) {
    throw errorAt(require(key), key,
                  "has " + std::to_string(nodes.size()) + " values, must be a list of " +
                      std::to_string(count) + " numbers");
  }
  std::vector<double> values;
  values.reserve(nodes.size());
  for (const YAML::Node& node : nodes) {
    values.push_back(toNumber(key, node, range));
  }
  return values;
}

std::vector<int> YamlMap::integers(const std::string& key, int lowest, int highest) const {
  std::vector<int> values;
  for (const YAML::Node& node : sequence(key)) {
    values.push_back(static_cast<int>(toInteger(key, node, lowest, highest)));
  }
  if (values.empty()) {
    throw errorAt(require(key), key, "is empty, must be a list of whole numbers");
  }
  return values;
}

std::vector<std::string> YamlMap::texts(const std::string& key) const {
  std::vector<std::string> values;
  for (const YAML::Node& node : sequence(key)) {
    if (!node.IsScalar() || node.Scalar().empty()) {
      throw errorAt(node, key, shown(node) + ", must be a text");
    }
    values.push_back(node.Scalar());
  }
  if (values.empty()) {
    throw errorAt(require(key), key, "is empty, must be a list of texts");
  }
  return values;
}

std::vector<std::string> YamlMap::words(const std::string& key,
                                        const std::vector<std::string>& allowed) const {
  std::vector<std::string> values = texts(key);
  for (const std::string& value : values) {
    if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
      throw errorAt(require(key), key,
                    "has " + inQuotes(value) + ", each must be one of " + join(allowed));
    }
  }
  return values;
}

Cell YamlMap::cell(const std::string& key) const {
  const YAML::Node node = require(key);
  if (!node.IsSequence() || node.size() != 2) {
    throw errorAt(node, key, shown(node) + ", must be [row, col]");
  }
  // Any cell: whether it is on the map is for those to say who know the map.
  constexpr int kLargest = std::numeric_limits<int>::max();
  return {static_cast<int>(toInteger(key, node[0], -kLargest, kLargest)),
          static_cast<int>(toInteger(key, node[1], -kLargest, kLargest))};
}

std::optional<YamlMap> YamlMap::map(const std::string& key) const {
  if (!has(key)) {
    return std::nullopt;
  }
  const YAML::Node node = require(key);
  if (!node.IsMap()) {
    throw errorAt(node, key, shown(node) + ", must be a mapping");
  }
  return YamlMap(path_, prefix_ + key + ".", node);
}

std::vector<YamlMap> YamlMap::maps(const std::string& key) const {
  const std::vector<YAML::Node> nodes = sequence(key);
  if (nodes.empty()) {
    throw errorAt(require(key), key, "is empty, must be a list of mappings");
  }
  std::vector<YamlMap> maps;
  for (const YAML::Node& node : nodes) {
    const std::string element = key + "[" + std::to_string(maps.size()) + "]";
    if (!node.IsMap()) {
      throw errorAt(node, element, shown(node) + ", must be a mapping");
    }
    maps.push_back(YamlMap(path_, prefix_ + element + ".", node));
  }
  return maps;
}

std::runtime_error YamlMap::error(const std::string& key, const std::string& what) const {
  return errorAt(has(key) ? find(key) : *node_, key, what);
}

YAML::Node YamlMap::find(const std::string& key) const {
  // What is asked for is what may be there: refuseUnread() needs no list of its own.
  if (std::find(asked_->begin(), asked_->end(), key) == asked_->end()) {
    asked_->push_back(key);
  }
  return (*node_)[key];
}

YAML::Node YamlMap::require(const std::string& key) const {
  if (!has(key)) {
    throw errorAt(*node_, key, "is missing");
  }
  return find(key);
}

std::vector<YAML::Node> YamlMap::sequence(const std::string& key) const {
  const YAML::Node node = require(key);
  if (!node.IsSequence()) {
    throw errorAt(node, key, shown(node) + ", must be a list");
  }
  return {node.begin(), node.end()};
}

double YamlMap::toNumber(const std::string& key, const YAML::Node& node, const Range& range) const {
  double value = 0.0;
  const bool is_number = node.IsScalar() && YAML::convert<double>::decode(node, value);
  if (!is_number || !range.contains(value)) {
    throw errorAt(node, key, shown(node) + ", must be a number " + toString(range));
  }
  return value;
}

std::int64_t YamlMap::toInteger(const std::string& key, const YAML::Node& node, std::int64_t lowest,
                                std::int64_t highest) const {
  std::int64_t value = 0;
  const bool is_integer = node.IsScalar() && YAML::convert<std::int64_t>::decode(node, value);
  if (!is_integer || value < lowest || value > highest) {
    throw errorAt(node, key,
                  shown(node) + ", must be a whole number " + std::to_string(lowest) + " ... " +
                      std::to_string(highest));
  }
  return value;
}

std::runtime_error YamlMap::errorAt(const YAML::Node& node, const std::string& key,
                                    const std::string& what) const {
  return fileError(path_, lineOf(node.Mark()), prefix_ + key + ": " + what);
}

}  // namespace sylph
