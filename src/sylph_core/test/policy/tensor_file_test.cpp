#include "sylph_core/policy/tensor_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "sylph_core/grid/rng.hpp"

namespace sylph {
namespace {

std::string pathOf(const std::string& name) {
  return ::testing::TempDir() + name;
}

std::string writeBytes(const std::string& bytes) {
  std::string path = pathOf("bad.safetensors");
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string withHeader(const std::string& header, const std::string& data) {
  const std::uint64_t size = header.size();
  std::string bytes(sizeof(size), '\0');
  std::memcpy(bytes.data(), &size, sizeof(size));
  return bytes + header + data;
}

std::string errorOf(const std::string& bytes) {
  const std::string path = writeBytes(bytes);
  try {
    loadTensorFile(path);
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(0U, std::string(error.what()).find(path));
    return error.what();
  }
  return "";
}

TEST(TensorFileTest, ThereAndBackIsTheIdentity) {
  TensorFile file;
  file.tensors["a"] = {{2, 3}, {1.F, 2.F, 3.F, 4.F, 5.F, -6.5F}};
  file.tensors["scalar"] = {{}, {7.F}};
  file.tensors["none"] = {{0, 4}, {}};
  file.metadata["run"] = "first \"quoted\"";
  const std::string path = pathOf("good.safetensors");
  saveTensorFile(file, path);
  const TensorFile read = loadTensorFile(path);
  EXPECT_EQ(file.metadata, read.metadata);
  ASSERT_EQ(3U, read.tensors.size());
  for (const auto& [name, tensor] : file.tensors) {
    EXPECT_EQ(tensor.shape, read.tensors.at(name).shape);
    EXPECT_EQ(tensor.values, read.tensors.at(name).values);
  }
  EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
}

TEST(TensorFileTest, ATensorMayBeEmpty) {
  TensorFile file;
  file.tensors["a"] = {{0, 3}, {}};
  const std::string path = pathOf("empty.safetensors");
  saveTensorFile(file, path);
  EXPECT_EQ(file.tensors["a"].shape, loadTensorFile(path).tensors.at("a").shape);
  EXPECT_TRUE(loadTensorFile(path).tensors.at("a").values.empty());
}

TEST(TensorFileTest, RefusesToWriteValuesThatDoNotFillTheShape) {
  TensorFile file;
  file.tensors["a"] = {{2, 2}, {1.F}};
  EXPECT_THROW(saveTensorFile(file, pathOf("never.safetensors")), std::invalid_argument);
}

TEST(TensorFileTest, SaysWhatIsWrongWithAFile) {
  const std::string four(4, '\0');
  EXPECT_NE("", errorOf(""));
  EXPECT_NE(std::string::npos, errorOf("abc").find("8 bytes"));
  EXPECT_NE(std::string::npos, errorOf(std::string(8, '\xff')).find("claims a header"));
  EXPECT_NE(std::string::npos, errorOf(withHeader("{nonsense", "")).find("bad header"));
  EXPECT_NE(std::string::npos, errorOf(withHeader("[1]", "")).find("bad header"));
  const auto entry = [&](const std::string& type, const std::string& shape,
                         const std::string& offsets) {
    return errorOf(withHeader(R"({"w":{"dtype":")" + type + R"(","shape":)" + shape +
                                  R"(,"data_offsets":)" + offsets + "}}",
                              four));
  };
  EXPECT_EQ("", entry("F32", "[1]", "[0,4]"));
  EXPECT_NE(std::string::npos, entry("F16", "[2]", "[0,4]").find("must be F32"));
  EXPECT_NE(std::string::npos, entry("F32", "[2]", "[0,8]").find("data_offsets"));
  EXPECT_NE(std::string::npos, entry("F32", "[1]", "[4,0]").find("data_offsets"));
  EXPECT_NE(std::string::npos, entry("F32", "[1]", "[0]").find("data_offsets"));
  EXPECT_NE(std::string::npos, entry("F32", "[-1]", "[0,4]").find("shape"));
  EXPECT_NE(std::string::npos, entry("F32", "[4294967295,4294967295]", "[0,4]").find("shape"));
  EXPECT_NE(std::string::npos, entry("F32", "\"x\"", "[0,4]").find("bad header"));
  for (const std::string number : {"1e300", "1.5", "true", "18446744073709551616"}) {
    EXPECT_NE(std::string::npos, entry("F32", "[" + number + "]", "[0,4]").find("whole number"));
    EXPECT_NE(std::string::npos, entry("F32", "[1]", "[0," + number + "]").find("whole number"));
  }
  EXPECT_NE(std::string::npos, entry("F32", "[1]", "[-4,0]").find("whole number"));
  EXPECT_THROW(loadTensorFile(pathOf("missing.safetensors")), std::runtime_error);
}

TEST(TensorFileTest, AnErrorIsOneLineWhateverTensorsAreCalled) {
  const std::string error =
      errorOf(withHeader(R"({"a\nb":{"dtype":"F\n16","shape":[],"data_offsets":[0,4]}})", ""));
  EXPECT_NE(std::string::npos, error.find("tensor 'a?b' is of type F?16: must be F32")) << error;
}

TEST(TensorFileProperty, ABrokenFileIsReadOrRefusedWithItsName) {
  TensorFile file;
  file.tensors["a"] = {{2, 3}, {1.F, 2.F, 3.F, 4.F, 5.F, 6.F}};
  file.metadata["run"] = "x";
  const std::string path = pathOf("whole.safetensors");
  saveTensorFile(file, path);
  std::ifstream stream(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    EXPECT_NE("", errorOf(whole.substr(0, cut))) << "cut at " << cut;
  }
  Rng rng(1);
  int refused = 0;
  for (int round = 0; round < 500; ++round) {
    std::string broken = whole;
    broken[drawIndex(rng, broken.size())] = static_cast<char>(drawIndex(rng, 256));
    refused += errorOf(broken).empty() ? 0 : 1;  // errorOf() checks that the file is named
  }
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace sylph
