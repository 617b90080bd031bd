#pragma once

#include <string>

namespace sylph {

/// A number as printf() writes it: format("%.1f s", 1.25) is "1.2 s".
/// @param pattern  with one conversion, of a double; what comes after 255 characters is cut off
std::string format(const char* pattern, double value);

}  // namespace sylph
