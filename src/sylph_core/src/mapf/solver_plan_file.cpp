#include "sylph_core/mapf/solver_plan_file.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "files/text_file.hpp"
#include "mapf/plan_scanner.hpp"
#include "sylph_core/mapf/plan_file.hpp"

namespace sylph {
namespace {

/// What stands in one line of a file.
/// @param form  of such a line
/// @param read  takes a PlanScanner, throws std::invalid_argument with what it expected
template <typename Read>
auto readLine(const std::string& path, std::size_t number, const std::string& line,
              const std::string& form, const Read& read) {
  PlanScanner scanner(line);
  try {
    return read(scanner);
  } catch (const std::invalid_argument& expected) {
    throw fileError(path, number,
                    inQuotes(scanner.rest()) + ": must be " + expected.what() +
                        " here, a line is '" + form + "'");
  }
}

Configuration readLacamCells(PlanScanner& scanner) {
  Configuration cells;
  while (!scanner.isAtEnd()) {
    const Cell swapped = scanner.cell();
    cells.push_back({swapped.col, swapped.row});
    if (!scanner.isAtEnd()) {
      scanner.mark(",");
    }
  }
  return cells;
}

std::optional<Plan> loadLacamPlan(const std::string& path) {
  const std::vector<std::string> lines = splitLines(readTextFile(path, kMaxPlanBytes));
  const auto solution = std::find(lines.begin(), lines.end(), "solution=");
  if (std::find(lines.begin(), solution, "solved=0") != solution) {
    return std::nullopt;
  }
  if (solution == lines.end()) {
    throw fileError(path, 0, "has no line 'solution=' and no line 'solved=0'");
  }
  Plan plan;
  for (auto line = solution + 1; line != lines.end(); ++line) {
    const auto number = static_cast<std::size_t>(line - lines.begin()) + 1;
    const auto step = static_cast<int>(plan.size());
    plan.push_back(readLine(path, number, *line, "step:(x,y),(x,y),", [&](PlanScanner& scanner) {
      if (const int found = scanner.number(); found != step) {
        throw fileError(path, number,
                        "step " + std::to_string(found) + ": must be " + std::to_string(step));
      }
      scanner.mark(":");
      return readLacamCells(scanner);
    }));
    if (plan.back().empty() || plan.back().size() != plan.front().size()) {
      throw fileError(
          path, number,
          std::to_string(plan.back().size()) + " agents: must be " +
              (plan.front().empty() ? "1 or more"
                                    : std::to_string(plan.front().size()) + ", as in step 0"));
    }
  }
  if (plan.empty()) {
    throw fileError(path, lines.size(), "has no step below 'solution='");
  }
  return plan;
}

/// The cells of one agent, from timestep 0 on.
std::vector<Cell> readPath(PlanScanner& scanner, std::size_t agent) {
  scanner.mark("Agent " + std::to_string(agent) + ":");
  std::vector<Cell> path;
  while (!scanner.isAtEnd()) {
    path.push_back(scanner.cell());
    if (!scanner.isAtEnd()) {
      scanner.mark("->");
    }
  }
  return path;
}

Plan loadPaths(const std::string& path) {
  const std::vector<std::string> lines = splitLines(readTextFile(path, kMaxPlanBytes));
  if (lines.empty()) {
    throw fileError(path, 0, "is empty, must start with 'Agent 0:(row,col)->'");
  }
  std::vector<std::vector<Cell>> paths;
  std::size_t longest = 0;
  for (const std::string& line : lines) {
    const std::size_t agent = paths.size();
    paths.push_back(readLine(path, agent + 1, line, "Agent N:(row,col)->(row,col)->",
                             [&](PlanScanner& scanner) { return readPath(scanner, agent); }));
    if (paths.back().empty()) {
      throw fileError(path, paths.size(), "agent " + std::to_string(agent) + " has no cell");
    }
    longest = std::max(longest, paths.back().size());
  }
  // Each agent's path is as long as the longest one: a small file may stand for a plan without end.
  if (longest > kMaxPlanBytes / sizeof(Cell) / paths.size()) {
    throw fileError(path, 0,
                    std::to_string(longest - 1) + " steps of " + std::to_string(paths.size()) +
                        " agents: is too large");
  }
  Plan plan(longest);
  for (std::size_t step = 0; step < longest; ++step) {
    for (const std::vector<Cell>& cells : paths) {
      plan[step].push_back(cells[std::min(step, cells.size() - 1)]);
    }
  }
  return plan;
}

}  // namespace

std::optional<Plan> loadSolverPlan(const std::string& path, PlanFormat format) {
  switch (format) {
    case PlanFormat::Lacam:
      return loadLacamPlan(path);
    case PlanFormat::Paths:
      return loadPaths(path);
    case PlanFormat::Sylph:
      break;
  }
  return loadPlan(path);
}

}  // namespace sylph
