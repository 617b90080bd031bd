#pragma once

#include <string>
#include <vector>

namespace sylph {

/// How a program ended.
struct ProgramEnd {
  bool was_killed = false;  ///< it still ran at the limit
  int signal = 0;           ///< what killed it otherwise, 0 if nothing did
  int status = 0;           ///< with which it exited, if nothing killed it
  double seconds = 0.0;     ///< wall time [s]
};

/// Runs a program, without a shell, until it ends. It is a process group of its own, of which
/// nothing is left then: it is killed, and when the calling thread ends, the program too.
/// @param words     path of the program, then its arguments
/// @param folder    in which it runs
/// @param log_path  file for its standard output and standard error; it has no standard input
/// @param limit_s   wall time after which it is killed [s], > 0
/// @throws std::runtime_error if the log cannot be written or there can be no further process
ProgramEnd runProgram(const std::vector<std::string>& words, const std::string& folder,
                      const std::string& log_path, double limit_s);

}  // namespace sylph
