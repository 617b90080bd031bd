#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

/// What the fuzzers of readers share: files to be read, and the answer that each of them is due.
namespace sylph::fuzz {

/// A folder for files, removed when the fuzzer ends.
class Folder {
 public:
  Folder() : path_((std::filesystem::temp_directory_path() / "fuzz_XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) {
      throw std::runtime_error("no temporary folder at " + path_);
    }
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const {
    std::string path = path_ + "/" + name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

 private:
  std::string path_;
};

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
