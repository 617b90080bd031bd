#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/benchmark/run_outcome.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/solver_plan_file.hpp"

namespace sylph {

/// A solver that is a program of its own.
struct ExternalSolver {
  std::string name;                            ///< as in tables
  std::vector<std::string> command;            ///< program and arguments, see splitCommand()
  PlanFormat plan_format = PlanFormat::Sylph;  ///< of what it writes
  double grace_s = 5.0;  ///< from the time limit until it is killed [s], > 0: to start and to write
  std::string folder;    ///< in which it runs, and from which the program's path is taken
  std::string source;    ///< begin of messages on the command: "file:line: field: "
};

/// Splits a command at blanks. Placeholders are words or parts of words:
///
///     {map}      file of the map, MovingAI .map
///     {scen}     file of starts and goals, MovingAI .scen, one line an agent
///     {agents}   number of agents
///     {seconds}  time limit [s]
///     {seed}     whole number, the instance's
///     {plan}     file that the solver is to write; must be there
///
/// @throws std::invalid_argument naming an unknown placeholder, or that {plan} is missing
std::vector<std::string> splitCommand(const std::string& text);

/// The program of a solver: taken from its folder if there is a '/' in it, else found on the PATH.
/// @throws std::runtime_error that begins with its source if there is none that can be executed
std::string findProgram(const ExternalSolver& solver);

/// What a solver gave.
struct SolverAnswer {
  RunOutcome outcome = RunOutcome::Failed;  ///< Solved: it wrote a plan, which nobody has checked
  Plan plan;                                ///< empty unless Solved
  double seconds = 0.0;                     ///< wall time from its start to its end [s]
  std::string message;                      ///< one line on what went wrong, else empty
};

/// Runs a solver on an instance, in a temporary folder for its files.
/// @param time_limit_s  what it is told; it is killed, with all that it started, grace_s later
/// @throws std::runtime_error as findProgram(), or if the temporary files cannot be written
SolverAnswer solve(const ExternalSolver& solver, const Instance& instance, std::uint32_t seed,
                   double time_limit_s);

}  // namespace sylph
