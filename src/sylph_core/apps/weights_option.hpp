#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sylph_core/planners/planner.hpp"
#include "sylph_core/policy/policy.hpp"

namespace sylph {

/// The suite's own weights, which the commands use unless told otherwise.
inline const std::string kDefaultWeights = SYLPH_DEFAULT_WEIGHTS;

inline void addWeightsOption(CLI::App& app, std::string& path) {
  app.add_option("--weights", path,
                 "of the policy, for planners that have one\n(default: " + kDefaultWeights + ")");
}

/// The policy for some planners, nullptr if none of them has one.
/// @param path  as given by --weights, empty if it was not given
/// @throws std::invalid_argument if no weights are given where they are needed, or the reverse
/// @throws std::runtime_error as Policy::load()
inline std::shared_ptr<const Policy> loadPolicy(const std::vector<std::string>& planners,
                                                const std::string& path) {
  const auto planner = std::find_if(planners.begin(), planners.end(), needsPolicy);
  if (planner == planners.end()) {
    if (!path.empty()) {
      throw std::invalid_argument("--weights: planner '" + planners.front() + "' takes none");
    }
    return nullptr;
  }
  if (path.empty() && !std::filesystem::exists(kDefaultWeights)) {
    throw std::invalid_argument("--weights is required by planner '" + *planner +
                                "': there is no " + kDefaultWeights);
  }
  return std::make_shared<const Policy>(Policy::load(path.empty() ? kDefaultWeights : path));
}

}  // namespace sylph
