#include "sylph_adg_central/run_folder.hpp"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/files/write_file.hpp"

namespace sylph_adg_central {
namespace {

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A file of the folder by which a run is known.
struct Mark {
  std::string name;
  std::string content;
  std::string difference;  ///< what a run is that has another content
};

std::vector<Mark> marksOf(const sylph::Experiment& experiment) {
  const std::filesystem::path map = experiment.map_path;
  std::vector<Mark> marks = {
      {"experiment.yaml", contentOf(experiment.path), "of another experiment"},
      {"map" + map.extension().string(), contentOf(map), "on another map"},
      {"seed.txt", std::to_string(experiment.seed) + "\n", "of another seed"}};
  if (map.extension() != ".map") {  // of map_server, beside its image
    const std::filesystem::path image = YAML::LoadFile(map)["image"].as<std::string>();
    marks.push_back({"map" + image.extension().string(), contentOf(map.parent_path() / image),
                     "on another map"});
  }
  return marks;
}

}  // namespace

RunFolder::RunFolder(std::string path, const sylph::Experiment& experiment, bool is_ours)
    : path_(std::move(path)) {
  const std::vector<Mark> marks = marksOf(experiment);
  for (const Mark& mark : marks) {
    const std::string there = path_ + "/" + mark.name;
    if (!is_ours && std::filesystem::exists(there) && contentOf(there) != mark.content) {
      refuse(mark.difference);
    }
  }
  // A result without events is of a mission that failed before it began; with them the log decides,
  // see CentralNode::rebuild().
  if (!is_ours && std::filesystem::exists(result()) && !std::filesystem::exists(eventLog())) {
    refuse("that is over");
  }
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) {
    throw std::runtime_error("run folder " + path_ + ": " + error.message());
  }
  for (const Mark& mark : marks) {
    sylph::writeFile(path_ + "/" + mark.name, mark.content);
  }
}

void RunFolder::refuse(const std::string& why) const {
  throw std::runtime_error("run folder " + path_ + ": holds a run " + why +
                           "; name one that does not exist yet, or none");
}

std::string defaultRunFolder(const std::string& experiment, std::time_t now) {
  std::string home;
  if (const char* ros_home = std::getenv("ROS_HOME")) {
    home = ros_home;
  } else if (const char* user_home = std::getenv("HOME")) {
    home = std::string(user_home) + "/.ros";
  } else {
    throw std::runtime_error("run folder: neither ROS_HOME nor HOME is set");
  }
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 32> stamp{};
  std::strftime(stamp.data(), stamp.size(), "%Y-%m-%d_%H-%M-%S", &local);
  return home + "/sylph/" + stamp.data() + "_" + experiment;
}

}  // namespace sylph_adg_central
