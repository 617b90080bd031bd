#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

namespace sylph {

/// A folder for the files of one test, removed with it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string pattern =
        (std::filesystem::temp_directory_path() / (std::string(test->name()) + "_XXXXXX")).string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("no temporary folder at " + pattern);
    }
    path_ = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::string path(const std::string& name) const { return path_ + "/" + name; }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

 private:
  std::string path_;
};

/// What `work` says when it throws a runtime_error, which must be one line; empty if it does not.
inline std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    std::string message = error.what();
    EXPECT_EQ(std::string::npos, message.find('\n')) << message;
    return message;
  }
  return "";
}

/// Expects `work` to throw a runtime_error whose one line ends in `expected`.
inline void expectError(const std::string& expected, const std::function<void()>& work) {
  const std::string message = errorOf(work);
  const std::size_t length = std::min(expected.size(), message.size());
  EXPECT_EQ(expected, message.substr(message.size() - length)) << "whole message: " << message;
}

}  // namespace sylph
