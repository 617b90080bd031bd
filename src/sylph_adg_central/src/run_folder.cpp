#include "sylph_adg_central/run_folder.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sylph_adg_central {
namespace {

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

RunFolder::RunFolder(std::string path, const sylph::Experiment& experiment, bool is_ours)
    : path_(std::move(path)) {
  const std::string copy = path_ + "/experiment.yaml";
  if (!is_ours && std::filesystem::exists(copy) && contentOf(copy) != contentOf(experiment.path)) {
    refuse("of another experiment");
  }
  // A result without events is of a mission that failed before it began; with them the log decides,
  // see CentralNode::rebuild().
  if (!is_ours && std::filesystem::exists(result()) && !std::filesystem::exists(eventLog())) {
    refuse("that is over");
  }
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (!error) {
    std::filesystem::copy_file(experiment.path, copy,
                               std::filesystem::copy_options::overwrite_existing, error);
  }
  if (error) {
    throw std::runtime_error("run folder " + path_ + ": " + error.message());
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
