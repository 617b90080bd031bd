#include "sylph_core/files/write_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "sylph_core/policy/tensor_file.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(WriteFileTest, ReplacesAFileOrAddsToIt) {
  const TemporaryFolder folder;
  const std::string path = folder.path("a.txt");
  writeFile(path, "old\r\n");
  writeFile(path, "new\n");
  writeFile(path, "more\n", std::ios::app);
  EXPECT_EQ("new\nmore\n", contentOf(path));
}

TEST(WriteFileTest, SaysWhyAFileCannotBeWritten) {
  for (const std::string& content : {std::string("short"), std::string(1 << 20, 'x')}) {
    for (const auto mode : {std::ios::trunc, std::ios::app}) {
      EXPECT_EQ("/dev/full: cannot be written: No space left on device",
                errorOf([&] { writeFile("/dev/full", content, mode); }));
    }
  }
  EXPECT_EQ("/nowhere/a: cannot be written: No such file or directory",
            errorOf([] { writeFile("/nowhere/a", ""); }));
  EXPECT_EQ("/tmp: cannot be written: Is a directory", errorOf([] { writeFile("/tmp", ""); }));
}

TEST(WriteFileTest, WeightsOnAFullDiskSayWhyAndLeaveThoseOfBefore) {
  const TemporaryFolder folder;
  const std::string path = folder.path("w.safetensors");
  saveTensorFile({}, path);
  const std::string before = contentOf(path);
  std::filesystem::create_symlink("/dev/full", path + ".partial");
  EXPECT_EQ(path + ".partial: cannot be written: No space left on device",
            errorOf([&] { saveTensorFile({}, path); }));
  EXPECT_EQ(before, contentOf(path));
}

}  // namespace
}  // namespace sylph
