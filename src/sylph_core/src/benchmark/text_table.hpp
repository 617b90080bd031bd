#pragma once

#include <string>
#include <vector>

namespace sylph {

/// Columns as wide as their widest cell, the first two to the left, the others to the right.
/// @param rows  one or more, each of as many cells
std::string alignTable(const std::vector<std::vector<std::string>>& rows);

/// Cells "1.234" and "1.200..1.260" of a mean and its 95 % interval, "-" where there is none.
std::vector<std::string> meanCells(const std::vector<double>& values);

}  // namespace sylph
