#include "sylph_ros/experiment.hpp"

#include "sylph_ros/parameters.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_ros {

sylph::Experiment loadExperiment(const ros::NodeHandle& suite_nh, const std::string& own_path) {
  sylph::ExperimentOverrides overrides;
  int seed = -1;
  read(suite_nh, kSeedParameter, seed, sylph::Range::atLeast(-1.0));
  if (seed >= 0) {
    overrides.seed = static_cast<std::uint32_t>(seed);
  }
  std::string planner;
  read(suite_nh, kPlannerParameter, planner);
  if (!planner.empty()) {
    overrides.planner = planner;
  }
  std::string weights;
  read(suite_nh, kWeightsParameter, weights);
  if (!weights.empty()) {
    overrides.weights_path = weights;
  }
  return sylph::loadExperiment(
      own_path.empty() ? readRequiredString(suite_nh, kExperimentParameter) : own_path, overrides);
}

}  // namespace sylph_ros
