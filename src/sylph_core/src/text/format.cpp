#include "sylph_core/text/format.hpp"

#include <array>
#include <cstdio>

namespace sylph {

std::string format(const char* pattern, double value) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), pattern, value);
  return text.data();
}

}  // namespace sylph
