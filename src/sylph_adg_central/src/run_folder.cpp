#include "sylph_adg_central/run_folder.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace sylph_adg_central {

RunFolder::RunFolder(std::string path, const sylph::Experiment& experiment)
    : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (!error) {
    std::filesystem::copy_file(experiment.path, path_ + "/experiment.yaml",
                               std::filesystem::copy_options::overwrite_existing, error);
  }
  if (error) {
    throw std::runtime_error("run folder " + path_ + ": " + error.message());
  }
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
