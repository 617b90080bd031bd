#include "sylph_core/mapf/scenario_file.hpp"

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "files/text_file.hpp"
#include "sylph_core/files/write_file.hpp"
#include "sylph_core/grid/distance_field.hpp"

namespace sylph {
namespace {

constexpr std::size_t kMaxScenarioBytes = std::size_t{64} << 20;
constexpr std::size_t kFieldCount = 9;
constexpr int kBucketLength = 4;  // buckets of the benchmark are four steps of optimal length wide

/// One line's number and its fields.
class Fields {
 public:
  Fields(const std::string& path, std::size_t line, const std::string& text)
      : path_(path), line_(line) {
    std::istringstream in(text);
    for (std::string field; in >> field;) {
      fields_.push_back(field);
    }
    if (fields_.size() != kFieldCount) {
      throw fileError(path, line,
                      std::to_string(fields_.size()) +
                          " fields, must be 9: bucket, map, width, height, start x, start y, "
                          "goal x, goal y, length");
    }
  }

  int number(std::size_t index, const char* name, int lowest, int highest) const {
    try {
      return parseInteger(fields_[index], lowest, highest);
    } catch (const std::invalid_argument& error) {
      throw fileError(path_, line_, std::string(name) + " " + error.what());
    }
  }

 private:
  std::string path_;
  std::size_t line_;
  std::vector<std::string> fields_;
};

}  // namespace

Instance loadScenario(const std::string& path, const Grid& grid, int agents,
                      const MotionModel& motion) {
  const std::vector<std::string> lines = splitLines(readTextFile(path, kMaxScenarioBytes));
  if (lines.empty()) {
    throw fileError(path, 0, "is empty, must start with 'version 1'");
  }
  if (lines[0] != "version 1" && lines[0] != "version 1.0") {
    throw fileError(path, 1, inQuotes(lines[0]) + ": must be 'version 1'");
  }
  if (agents < 1 || lines.size() - 1 < static_cast<std::size_t>(agents)) {
    throw fileError(
        path, 0,
        "has " + std::to_string(lines.size() - 1) + " agents, asked for " + std::to_string(agents));
  }
  Instance instance{grid, {}, {}, motion};
  for (std::size_t index = 1; index <= static_cast<std::size_t>(agents); ++index) {
    const Fields fields(path, index + 1, lines[index]);
    fields.number(2, "width", grid.cols(), grid.cols());
    fields.number(3, "height", grid.rows(), grid.rows());
    instance.starts.push_back({fields.number(5, "start y", 0, grid.rows() - 1),
                               fields.number(4, "start x", 0, grid.cols() - 1)});
    instance.goals.push_back({fields.number(7, "goal y", 0, grid.rows() - 1),
                              fields.number(6, "goal x", 0, grid.cols() - 1)});
  }
  try {
    requireValid(instance);
  } catch (const std::invalid_argument& error) {
    throw fileError(path, 0, error.what());
  }
  return instance;
}

void saveScenario(const Instance& instance, const std::string& map_path, const std::string& path) {
  const std::string map_name = std::filesystem::path(map_path).filename().string();
  std::ostringstream out;
  out << "version 1\n";
  for (std::size_t agent = 0; agent < instance.starts.size(); ++agent) {
    const Cell& start = instance.starts[agent];
    const Cell& goal = instance.goals[agent];
    const int length = DistanceField(instance.grid, goal).at(start);
    out << length / kBucketLength << '\t' << map_name << '\t' << instance.grid.cols() << '\t'
        << instance.grid.rows() << '\t' << start.col << '\t' << start.row << '\t' << goal.col
        << '\t' << goal.row << '\t' << length << '\n';
  }
  writeFile(path, out.str());
}

}  // namespace sylph
