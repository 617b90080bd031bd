#include "files/text_file.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "text/one_line.hpp"

namespace sylph {

std::runtime_error fileError(const std::string& path, std::size_t line, const std::string& what) {
  return std::runtime_error(
      inOneLine(path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what));
}

std::string readTextFile(const std::string& path, std::size_t max_bytes) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw fileError(path, 0, "there is no such file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw fileError(path, 0, "is not a regular file");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw fileError(path, 0, std::string("cannot be read: ") + std::strerror(errno));
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (size > max_bytes) {
    throw fileError(path, 0, "is larger than " + std::to_string(max_bytes) + " bytes");
  }
  std::string content(static_cast<std::size_t>(size), '\0');
  file.read(content.data(), static_cast<std::streamsize>(size));
  content.resize(static_cast<std::size_t>(file.gcount()));
  return content;
}

std::vector<std::string> splitLines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    if (!lines.back().empty() && lines.back().back() == '\r') {
      lines.back().pop_back();
    }
    begin = end + 1;
  }
  while (!lines.empty() && lines.back().empty()) {
    lines.pop_back();
  }
  return lines;
}

int parseInteger(const std::string& text, int lowest, int highest) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < lowest || value > highest) {
    throw std::invalid_argument(inQuotes(text) + ": must be a whole number " +
                                std::to_string(lowest) + " ... " + std::to_string(highest));
  }
  return value;
}

std::string printable(const std::string& text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = text.size() > kLongest ? text.substr(0, kLongest - 3) + "..." : text;
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return std::isprint(c) == 0; }, '?');
  return shown;
}

std::string inQuotes(const std::string& text) {
  return "'" + printable(text) + "'";
}

std::string resolvePath(const std::string& naming_file, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::absolute(naming_file).parent_path();
  return (folder / path).lexically_normal().string();
}

}  // namespace sylph
