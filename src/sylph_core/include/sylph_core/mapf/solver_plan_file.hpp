#pragma once

#include <optional>
#include <string>

#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// How solvers write their plans.
enum class PlanFormat {
  Sylph,  ///< as savePlan()
  /// LaCAM, LaCAM2, lacam3: lines "key=value", "solution=" the last of them, then one configuration
  /// a line: "step:(x,y),(x,y),", where x is the column and y the row. Other keys than "solved" and
  /// "solution" are passed over. github.com/Kei18/lacam3
  Lacam,
  /// MAPF-LNS2, EECBS with --outputPaths: a line for each agent, in order,
  /// "Agent 0:(row,col)->(row,col)->"; each rests at the end of its path.
  /// github.com/Jiaoyang-Li/MAPF-LNS2
  Paths,
};

/// Reads the plan that a solver has written. Whether it solves anything is for checkPlan() to say.
/// @return nothing if the file says that there is no solution: "solved=0"
/// @throws std::runtime_error with one line: file, line, what is wrong, what is allowed
std::optional<Plan> loadSolverPlan(const std::string& path, PlanFormat format);

}  // namespace sylph
