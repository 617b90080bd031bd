#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sylph {

/// Of the names that there are those that the writer of `name` may have meant, the nearest
/// first: by characters to insert, remove or replace (Levenshtein 1966), where only letters and
/// digits count and capitals do not.
/// @param most  names to give at most
std::vector<std::string> nearestNames(const std::string& name,
                                      const std::vector<std::string>& existing,
                                      std::size_t most = 2);

}  // namespace sylph
