#pragma once

#include <sylph_msgs/ExecuteMissionAction.h>

#include <memory>
#include <string>
#include <utility>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_core/policy/policy.hpp"

namespace sylph_planner_node {

/// The weights of a lab, read when a planner first needs them and never again.
class Weights {
 public:
  explicit Weights(std::string path) : path_(std::move(path)) {}

  /// @return nothing if the planner needs none
  /// @throws std::exception with one line if the file is of no use, or there is none
  std::shared_ptr<const sylph::Policy> of(const std::string& planner);

 private:
  std::string path_;
  std::shared_ptr<const sylph::Policy> policy_;
};

/// Reads a request, its map and the weights that its planner needs, and fills in the lab's planner
/// and time limit where it names none.
///
/// Robots must be robots of the lab. The map must have the size of the lab's map and its cells,
/// because the other nodes turn cells into metres by the lab's; its obstacles may differ.
/// @param weights  of the planner, if it needs some
/// @throws sylph::MissionFailure (BadRequest)
sylph::Mission readMission(const sylph_msgs::ExecuteMissionGoal& goal, const sylph::Experiment& lab,
                           Weights& weights);

}  // namespace sylph_planner_node
