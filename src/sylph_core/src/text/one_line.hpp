#pragma once

#include <algorithm>
#include <string>

namespace sylph {

/// For messages: control characters, line ends among them, as '?'.
inline std::string inOneLine(std::string text) {
  constexpr unsigned char kDelete = 0x7F;
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == kDelete; }, '?');
  return text;
}

}  // namespace sylph
