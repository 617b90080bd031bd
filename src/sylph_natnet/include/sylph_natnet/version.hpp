#pragma once

#include <string>
#include <tuple>

namespace sylph_natnet {

/// A bitstream (NatNet) version, not Motive's own version. It is compared as a pair: 2.9 < 3.0.
struct Version {
  int major = 0;
  int minor = 0;

  friend bool operator==(const Version& a, const Version& b) {
    return a.major == b.major && a.minor == b.minor;
  }
  friend bool operator!=(const Version& a, const Version& b) { return !(a == b); }
  friend bool operator<(const Version& a, const Version& b) {
    return std::tie(a.major, a.minor) < std::tie(b.major, b.minor);
  }
  friend bool operator>=(const Version& a, const Version& b) { return !(a < b); }
};

/// The newest bitstream whose every field is known here; since 4.2 none was added. Newer ones are
/// read if they keep 4.1's sections, whose sizes allow to skip what is unknown inside.
constexpr Version kNewestVersion{4, 4};
/// Streams before this are refused.
constexpr Version kOldestVersion{2, 0};

/// "4.1"
std::string toString(const Version& version);

/// @throws std::invalid_argument unless the text is MAJOR.MINOR, from kOldestVersion on
Version versionFromString(const std::string& text);

}  // namespace sylph_natnet
