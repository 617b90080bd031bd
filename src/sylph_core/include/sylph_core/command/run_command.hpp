#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>
#include <string>

namespace sylph {

constexpr int kBadInput = 2;  ///< exit status of a command that cannot use what it was given

/// For CLI::Option::check(): a time that can be waited for.
/// @return what is wrong, empty if nothing
inline std::string isPositiveSeconds(const std::string& text) {
  double seconds = 0.0;
  const bool is_positive = CLI::detail::lexical_cast(text, seconds) && seconds > 0.0;
  return is_positive && std::isfinite(seconds) ? "" : text + ": must be a number of seconds > 0";
}

/// Parses the command line and runs the command.
/// @return its exit status; kBadInput, after one line on standard error, if anything throws
inline int runCommand(CLI::App& app, int argc, const char* const* argv,
                      const std::function<int()>& command) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      return app.exit(error);  // --help
    }
    std::cerr << app.get_name() << ": " << error.what() << " (--help lists the options)\n";
    return kBadInput;
  }
  try {
    return command();
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << "\n";
    return kBadInput;
  }
}

}  // namespace sylph
