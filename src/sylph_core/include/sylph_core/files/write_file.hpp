#pragma once

#include <fstream>
#include <ios>
#include <string>

namespace sylph {

/// Writes a whole file, or adds to its end with std::ios::app.
/// @throws std::runtime_error with one line, "<path>: cannot be written: No space left on device"
void writeFile(const std::string& path, const std::string& content,
               std::ios::openmode mode = std::ios::trunc);

/// Closes a file that was written piece by piece.
/// @throws std::runtime_error as writeFile(), also if it could not be opened
void closeWritten(std::ofstream& file, const std::string& path);

}  // namespace sylph
