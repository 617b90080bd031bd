#include "sylph_core/benchmark/external_solver.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "benchmark/child_process.hpp"
#include "files/text_file.hpp"
#include "sylph_core/files/range.hpp"
#include "sylph_core/files/scratch_folder.hpp"
#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/mapf/scenario_file.hpp"
#include "sylph_core/text/join.hpp"
#include "text/one_line.hpp"

namespace sylph {
namespace {

const std::vector<std::string>& placeholders() {
  static const std::vector<std::string> kNames = {"{map}",     "{scen}", "{agents}",
                                                  "{seconds}", "{seed}", "{plan}"};
  return kNames;
}

void requireKnownPlaceholders(const std::string& word) {
  for (std::size_t open = word.find('{'); open != std::string::npos;
       open = word.find('{', open + 1)) {
    const std::size_t close = std::min(word.find('}', open), word.size() - 1);
    const std::string found = word.substr(open, close - open + 1);
    if (std::count(placeholders().begin(), placeholders().end(), found) == 0) {
      throw std::invalid_argument(inQuotes(found) + " is no placeholder, must be one of " +
                                  join(placeholders()));
    }
  }
}

/// Each placeholder gives way to its value, whatever stands in that.
std::string filledIn(const std::string& word,
                     const std::vector<std::pair<std::string, std::string>>& values) {
  std::string filled;
  for (std::size_t place = 0; place < word.size();) {
    const auto value = std::find_if(values.begin(), values.end(), [&](const auto& candidate) {
      return word.compare(place, candidate.first.size(), candidate.first) == 0;
    });
    filled += value == values.end() ? word.substr(place, 1) : value->second;
    place += value == values.end() ? 1 : value->first.size();
  }
  return filled;
}

bool isExecutable(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

/// The last lines of a log, for messages.
std::string lastLines(const std::string& path) {
  constexpr std::streamoff kMostBytes = 400;
  std::ifstream log(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = log.tellg();
  log.seekg(std::max<std::streamoff>(size - kMostBytes, 0));
  std::vector<std::string> lines;
  for (std::string line; std::getline(log, line);) {
    if (!line.empty()) {
      lines.push_back(line);
    }
  }
  constexpr std::ptrdiff_t kMostLines = 3;
  if (lines.end() - lines.begin() > kMostLines) {
    lines.erase(lines.begin(), lines.end() - kMostLines);
  }
  return lines.empty() ? "it printed nothing" : "its last lines: " + inOneLine(join(lines, " | "));
}

/// @param answer  its time; the rest is filled in
void readPlan(const std::string& path, PlanFormat format, SolverAnswer& answer) {
  try {
    std::optional<Plan> plan = loadSolverPlan(path, format);
    answer.outcome = plan ? RunOutcome::Solved : RunOutcome::NoSolution;
    answer.plan = plan ? std::move(*plan) : Plan();
  } catch (const std::runtime_error& error) {
    answer.outcome = RunOutcome::Invalid;
    answer.message = error.what();
  }
}

bool isThere(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && std::filesystem::file_size(path, error) != 0;
}

}  // namespace

std::vector<std::string> splitCommand(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) {
    requireKnownPlaceholders(word);
    words.push_back(word);
  }
  if (text.find("{plan}") == std::string::npos) {
    throw std::invalid_argument("has no {plan}, the file that the solver is to write");
  }
  return words;
}

std::string findProgram(const ExternalSolver& solver) {
  const std::string& name = solver.command.front();
  if (name.find('/') != std::string::npos) {
    const std::string path = (std::filesystem::path(solver.folder) / name).string();
    if (!isExecutable(path)) {
      throw std::runtime_error(
          inOneLine(solver.source + "there is no program " + path + " that can be executed"));
    }
    return path;
  }
  const char* const folders = std::getenv("PATH");
  std::istringstream in(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(in, folder, ':');) {
    const auto path = std::filesystem::absolute(std::filesystem::path(folder) / name);
    if (isExecutable(path.string())) {
      return path.string();
    }
  }
  throw std::runtime_error(
      inOneLine(solver.source + "there is no program " + inQuotes(name) + " on the PATH"));
}

SolverAnswer solve(const ExternalSolver& solver, const Instance& instance, std::uint32_t seed,
                   double time_limit_s) {
  const ScratchFolder folder("sylph_benchmark");
  const std::string map = folder.path("instance.map");
  const std::string scenario = folder.path("instance.scen");
  const std::string plan = folder.path("plan.txt");
  const std::string log = folder.path("log.txt");
  saveMap(instance.grid, map);
  saveScenario(instance, map, scenario);
  std::vector<std::string> words = {findProgram(solver)};
  for (std::size_t index = 1; index < solver.command.size(); ++index) {
    words.push_back(
        filledIn(solver.command[index], {{"{map}", map},
                                         {"{scen}", scenario},
                                         {"{agents}", std::to_string(instance.agentCount())},
                                         {"{seconds}", shortNumber(time_limit_s)},
                                         {"{seed}", std::to_string(seed)},
                                         {"{plan}", plan}}));
  }
  const ProgramEnd end = runProgram(words, solver.folder, log, time_limit_s + solver.grace_s);
  SolverAnswer answer;
  answer.seconds = end.seconds;
  if (end.was_killed) {
    answer.outcome = RunOutcome::TimeLimit;
  } else if (end.signal != 0) {
    answer.outcome = RunOutcome::Failed;
    answer.message =
        std::string("killed by a signal: ") + strsignal(end.signal) + "; " + lastLines(log);
  } else if (isThere(plan)) {
    readPlan(plan, solver.plan_format, answer);
  } else {
    answer.outcome = end.status == 0 ? RunOutcome::NoSolution : RunOutcome::Failed;
    answer.message = "no plan, exit status " + std::to_string(end.status) + "; " + lastLines(log);
  }
  return answer;
}

}  // namespace sylph
