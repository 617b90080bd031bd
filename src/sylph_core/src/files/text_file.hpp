#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace sylph {

/// An error in a file, in one line whatever the file is called: "path:line: what", the line from 1
/// or left out if 0.
std::runtime_error fileError(const std::string& path, std::size_t line, const std::string& what);

/// Content of a file.
/// @throws std::runtime_error naming the file if it cannot be read or is larger than `max_bytes`
std::string readTextFile(const std::string& path, std::size_t max_bytes);

/// Lines of a text without their ends ("\n" or "\r\n"); empty lines at the end are left out.
std::vector<std::string> splitLines(const std::string& text);

/// A whole number, all of `text`, within the bounds.
/// @throws std::invalid_argument "'text': must be a whole number lowest ... highest"
int parseInteger(const std::string& text, int lowest, int highest);

/// For messages: at most 40 characters, unprintable ones as '?'.
std::string printable(const std::string& text);

/// printable() in quotes.
std::string inQuotes(const std::string& text);

/// `path` itself if absolute, else taken from the folder of the file that names it.
std::string resolvePath(const std::string& naming_file, const std::string& path);

}  // namespace sylph
