#include "sylph_rviz/experiment_choices.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace sylph_rviz {
namespace {

namespace fs = std::filesystem;

std::string sizeText(const sylph::Experiment& experiment) {
  return std::to_string(experiment.grid.rows()) + " x " + std::to_string(experiment.grid.cols());
}

}  // namespace

std::string refusalOf(const sylph::Experiment& experiment, const sylph::Experiment& lab) {
  if (sizeText(experiment) != sizeText(lab)) {
    return "its map has " + sizeText(experiment) + " cells, the lab's " + sizeText(lab);
  }
  if (experiment.cell_size_m != lab.cell_size_m || experiment.corner.x != lab.corner.x ||
      experiment.corner.y != lab.corner.y) {
    return "its cells do not lie where the lab's do";
  }
  const std::vector<std::string> known = namesOf(lab);
  for (const sylph::RobotSpec& robot : experiment.robots) {
    if (std::find(known.begin(), known.end(), robot.name) == known.end()) {
      return "the lab has no robot " + robot.name;
    }
  }
  return "";
}

std::vector<ExperimentChoice> experimentChoices(const std::string& lab_path) {
  const sylph::Experiment lab = sylph::loadExperiment(lab_path);
  std::vector<ExperimentChoice> choices;
  std::error_code error;  // of a folder that may not be listed: the lab's own is all there is
  for (const fs::directory_entry& file :
       fs::directory_iterator(fs::path(lab_path).parent_path(), error)) {
    if (file.path().extension() != ".yaml" || file.path() == lab_path) {
      continue;
    }
    try {
      const sylph::Experiment experiment = sylph::loadExperiment(file.path().string());
      choices.push_back({experiment.name, file.path().string(), refusalOf(experiment, lab)});
    } catch (const std::exception&) {
      continue;  // a map's file, or of another program
    }
  }
  std::sort(choices.begin(), choices.end(),
            [](const ExperimentChoice& a, const ExperimentChoice& b) { return a.name < b.name; });
  choices.insert(choices.begin(), {lab.name, lab_path, ""});
  return choices;
}

}  // namespace sylph_rviz
