#include "sylph_core/mapf/plan_file.hpp"

#include <array>
#include <charconv>
#include <stdexcept>
#include <vector>

#include "files/text_file.hpp"
#include "mapf/plan_scanner.hpp"
#include "sylph_core/files/write_file.hpp"

namespace sylph {
namespace {

Configuration readConfiguration(const std::string& path, std::size_t line, PlanScanner& scanner) {
  try {
    // A line that is missing would shift all after it, unseen.
    if (const int step = scanner.number(); step != static_cast<int>(line) - 1) {
      throw fileError(path, line,
                      "step " + std::to_string(step) + ": must be " + std::to_string(line - 1));
    }
    scanner.mark(":");
    Configuration cells;
    while (!scanner.isAtEnd()) {
      cells.push_back(scanner.cell());
    }
    return cells;
  } catch (const std::invalid_argument& expected) {
    throw fileError(path, line,
                    inQuotes(scanner.rest()) + ": must be " + expected.what() +
                        " here, a line is 'step: (row,col) (row,col) ...'");
  }
}

/// Plans of thousands of agents have tens of millions of numbers.
void append(int value, std::string& text) {
  std::array<char, 12> digits{};
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

}  // namespace

Plan loadPlan(const std::string& path) {
  const std::vector<std::string> lines = splitLines(readTextFile(path, kMaxPlanBytes));
  if (lines.empty()) {
    throw fileError(path, 0, "is empty, must start with '0: (row,col) (row,col) ...'");
  }
  Plan plan;
  for (const std::string& line : lines) {
    PlanScanner scanner(line);
    plan.push_back(readConfiguration(path, plan.size() + 1, scanner));
    if (plan.back().empty() || plan.back().size() != plan.front().size()) {
      throw fileError(path, plan.size(),
                      std::to_string(plan.back().size()) + " agents: must be " +
                          (plan.front().empty()
                               ? "1 or more"
                               : std::to_string(plan.front().size()) + ", as in the first line"));
    }
  }
  return plan;
}

void savePlan(const Plan& plan, const std::string& path) {
  std::string text;
  for (std::size_t step = 0; step < plan.size(); ++step) {
    append(static_cast<int>(step), text);
    text += ':';
    for (const Cell& cell : plan[step]) {
      text += " (";
      append(cell.row, text);
      text += ',';
      append(cell.col, text);
      text += ')';
    }
    text += '\n';
  }
  writeFile(path, text);
}

}  // namespace sylph
