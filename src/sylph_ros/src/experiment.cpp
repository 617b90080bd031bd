#include "sylph_ros/experiment.hpp"

#include <limits>

#include "sylph_ros/parameters.hpp"

namespace sylph_ros {

sylph::Experiment loadExperiment(const ros::NodeHandle& private_nh) {
  sylph::ExperimentOverrides overrides;
  int seed = -1;
  read(private_nh, "seed", seed);
  requireInRange(private_nh, "seed", seed, -1, std::numeric_limits<int>::max());
  if (seed >= 0) {
    overrides.seed = static_cast<std::uint32_t>(seed);
  }
  std::string planner;
  read(private_nh, "planner", planner);
  if (!planner.empty()) {
    overrides.planner = planner;
  }
  std::string weights;
  read(private_nh, "weights", weights);
  if (!weights.empty()) {
    overrides.weights_path = weights;
  }
  return sylph::loadExperiment(readRequiredString(private_nh, "experiment"), overrides);
}

}  // namespace sylph_ros
