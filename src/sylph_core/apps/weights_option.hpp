#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "sylph_core/planners/planner.hpp"
#include "sylph_core/policy/policy.hpp"

namespace sylph {

/// The suite's own weights, which the commands use unless told otherwise: those of the install or
/// devel space around the command, of the repository around it, or of a package on
/// ROS_PACKAGE_PATH.
/// @return  empty if there are none
inline std::string findDefaultWeights() {
  const std::filesystem::path file = "weights/sylph.safetensors";
  std::vector<std::filesystem::path> folders;
  auto folder = std::filesystem::canonical("/proc/self/exe").parent_path();
  for (; folder != folder.root_path(); folder = folder.parent_path()) {
    folders.push_back(folder / "share/sylph_bringup");
    folders.push_back(folder);
  }
  const char* const packages = std::getenv("ROS_PACKAGE_PATH");
  std::istringstream list(packages == nullptr ? "" : packages);
  for (std::string entry; std::getline(list, entry, ':');) {
    folders.push_back(std::filesystem::path(entry) / "sylph_bringup");
  }
  for (const std::filesystem::path& around : folders) {
    if (std::filesystem::exists(around / file)) {
      return around / file;
    }
  }
  return "";
}

inline void addWeightsOption(CLI::App& app, std::string& path) {
  const std::string found = findDefaultWeights();
  app.add_option("--weights", path,
                 "of the policy, for planners that have one\n(default: " +
                     (found.empty() ? "none, as sylph_bringup is not installed" : found) + ")");
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
  const std::string file = path.empty() ? findDefaultWeights() : path;
  if (file.empty()) {
    throw std::invalid_argument("--weights is required by planner '" + *planner +
                                "': sylph_bringup, which has the suite's, is not installed");
  }
  return std::make_shared<const Policy>(Policy::load(file));
}

}  // namespace sylph
