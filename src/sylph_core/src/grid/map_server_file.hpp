#pragma once

#include <string>

#include "sylph_core/grid/map_file.hpp"

namespace sylph {

/// The map_server half of loadMapFile().
MapFile loadMapServerFile(const std::string& path);

}  // namespace sylph
