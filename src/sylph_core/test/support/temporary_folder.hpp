#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

#include "sylph_core/files/scratch_folder.hpp"

namespace sylph {

/// A folder for the files of one test, which has its name.
class TemporaryFolder : public ScratchFolder {
 public:
  TemporaryFolder()
      : ScratchFolder(::testing::UnitTest::GetInstance()->current_test_info()->name()) {}
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
