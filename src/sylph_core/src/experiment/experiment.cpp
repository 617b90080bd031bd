#include "sylph_core/experiment/experiment.hpp"

#include <stdexcept>

namespace sylph {

Experiment loadExperiment(const std::string& path, const ExperimentOverrides& /*overrides*/) {
  throw std::runtime_error(path + ": reading experiments is not written yet");
}

Instance toInstance(const Experiment& experiment) {
  Instance instance;
  instance.grid = experiment.grid;
  for (const RobotSpec& robot : experiment.robots) {
    instance.starts.push_back(robot.start);
    instance.goals.push_back(robot.goal);
  }
  return instance;
}

}  // namespace sylph
