#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "sylph_core/files/scratch_folder.hpp"

/// What the fuzzers of readers share: the answer that each file is due.
namespace sylph::fuzz {

inline std::string toText(const std::uint8_t* data, std::size_t size) {
  return {data, data + size};
}

/// Ends the fuzzer, which tells of it as of a crash.
[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "broken promise: %s\n", what.c_str());
  std::abort();
}

/// Reads. The answer is a value or, as headers promise, a runtime_error with one line; whatever
/// else is thrown ends the fuzzer.
template <typename Read>
void expectAnswer(const Read& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    if (message.empty() || message.find('\n') != std::string::npos) {
      fail("an error is one line, this is not: '" + message + "'");
    }
  }
}

}  // namespace sylph::fuzz
