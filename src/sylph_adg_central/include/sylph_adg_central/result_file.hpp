#pragma once

#include <string>

#include "sylph_core/adg/run_record.hpp"

namespace sylph_adg_central {

/// Writes `result.yaml` of a run folder.
/// @throws std::runtime_error if the file cannot be written
void writeResult(const sylph::RunResult& result, const std::string& path);

}  // namespace sylph_adg_central
