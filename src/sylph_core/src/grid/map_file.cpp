#include "sylph_core/grid/map_file.hpp"

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "files/text_file.hpp"
#include "grid/map_server_file.hpp"
#include "sylph_core/files/write_file.hpp"

namespace sylph {
namespace {

constexpr std::size_t kMaxMapBytes = std::size_t{Grid::kMaxSide} * (Grid::kMaxSide + 2) + 1024;
constexpr std::size_t kHeaderLines = 4;

/// The number in a header line such as "height 32".
int headerNumber(const std::string& path, const std::vector<std::string>& lines, std::size_t index,
                 const std::string& name) {
  const std::string& line = lines[index];
  if (line.rfind(name + " ", 0) != 0) {
    throw fileError(path, index + 1, inQuotes(line) + ": must be '" + name + " N'");
  }
  try {
    return parseInteger(line.substr(name.size() + 1), 1, Grid::kMaxSide);
  } catch (const std::invalid_argument& error) {
    throw fileError(path, index + 1, name + " " + error.what());
  }
}

/// @return whether a character of the map is an obstacle
bool readTerrain(const std::string& path, std::size_t line, char terrain) {
  switch (terrain) {
    case '.':
    case 'G':
    case 'S':
      return false;
    case '@':
    case 'O':
    case 'T':
    case 'W':
      return true;
    default:
      throw fileError(path, line,
                      inQuotes(std::string(1, terrain)) +
                          ": must be one of . G S (free) and @ O T W (obstacle)");
  }
}

Grid loadMovingAiMap(const std::string& path) {
  const std::vector<std::string> lines = splitLines(readTextFile(path, kMaxMapBytes));
  if (lines.empty()) {
    throw fileError(path, 0, "is empty, must start with 'type octile'");
  }
  if (lines[0] != "type octile") {
    throw fileError(path, 1, inQuotes(lines[0]) + ": must be 'type octile'");
  }
  if (lines.size() < kHeaderLines) {
    throw fileError(path, lines.size(), "ends within its header: type, height, width, map");
  }
  const int rows = headerNumber(path, lines, 1, "height");
  const int cols = headerNumber(path, lines, 2, "width");
  if (lines[3] != "map") {
    throw fileError(path, 4, inQuotes(lines[3]) + ": must be 'map'");
  }
  if (lines.size() - kHeaderLines != static_cast<std::size_t>(rows)) {
    throw fileError(
        path, lines.size(),
        std::to_string(lines.size() - kHeaderLines) + " rows: height says " + std::to_string(rows));
  }
  Grid grid(rows, cols);
  for (int row = 0; row < rows; ++row) {
    const std::size_t index = kHeaderLines + static_cast<std::size_t>(row);
    const std::string& line = lines[index];
    if (line.size() != static_cast<std::size_t>(cols)) {
      throw fileError(
          path, index + 1,
          std::to_string(line.size()) + " characters: width says " + std::to_string(cols));
    }
    for (int col = 0; col < cols; ++col) {
      grid.setObstacle({row, col},
                       readTerrain(path, index + 1, line[static_cast<std::size_t>(col)]));
    }
  }
  return grid;
}

}  // namespace

MapFile loadMapFile(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".map") {
    MapFile map;
    map.grid = loadMovingAiMap(path);
    return map;
  }
  if (ending == ".yaml" || ending == ".yml") {
    return loadMapServerFile(path);
  }
  throw fileError(path, 0, "a map's name must end in .map (MovingAI), .yaml or .yml (map_server)");
}

Grid loadMap(const std::string& path) {
  return loadMapFile(path).grid;
}

void saveMap(const Grid& grid, const std::string& path) {
  std::string text = "type octile\nheight " + std::to_string(grid.rows()) + "\nwidth " +
                     std::to_string(grid.cols()) + "\nmap\n";
  for (const char c : grid.toText()) {
    text.push_back(c == '#' ? '@' : c);
  }
  writeFile(path, text);
}

}  // namespace sylph
