#include "sylph_natnet/version.hpp"

#include <charconv>
#include <stdexcept>

namespace sylph_natnet {
namespace {

constexpr int kLargestPart = 255;  // one byte on the wire

/// @return the number that is all of the text, or -1
int numberFrom(const std::string& text) {
  int number = -1;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && number <= kLargestPart ? number : -1;
}

}  // namespace

std::string toString(const Version& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor);
}

Version versionFromString(const std::string& text) {
  const std::size_t dot = text.find('.');
  if (dot != std::string::npos) {
    const Version version{numberFrom(text.substr(0, dot)), numberFrom(text.substr(dot + 1))};
    if (version.minor >= 0 && version >= kOldestVersion) {
      return version;
    }
  }
  throw std::invalid_argument("bitstream version '" + text + "': must be MAJOR.MINOR, at least " +
                              toString(kOldestVersion));
}

}  // namespace sylph_natnet
