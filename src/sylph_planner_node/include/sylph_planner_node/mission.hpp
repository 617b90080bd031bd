#pragma once

#include <sylph_msgs/ExecuteMissionAction.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/policy/policy.hpp"

namespace sylph_planner_node {

/// Why a mission ends without success: an outcome of ExecuteMissionResult and one line for the
/// operator.
class MissionFailure : public std::runtime_error {
 public:
  MissionFailure(std::uint8_t outcome, const std::string& message)
      : std::runtime_error(message), outcome_(outcome) {}
  std::uint8_t outcome() const { return outcome_; }

 private:
  std::uint8_t outcome_;
};

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

/// A mission that has been checked as far as it can be without knowing where the robots are.
struct Mission {
  std::string map_path;
  sylph::Grid grid;
  double cell_size_m = 0.0;
  sylph::Point corner;  ///< lower left corner of the map [m]
  std::vector<std::string> robots;
  sylph::Configuration goals;  ///< one per robot, free and distinct
  std::string planner;
  std::shared_ptr<const sylph::Policy> policy;  ///< for planners that need one
  double time_limit_s = 0.0;
  std::uint32_t seed = 0;

  /// Index of a robot, or robots.size() if it has no part in the mission.
  std::size_t indexOf(const std::string& robot) const;
};

/// Reads a request, its map and the weights that its planner needs, and fills in the lab's planner
/// and time limit where it names none.
///
/// Robots must be robots of the lab. The map must have the size of the lab's map and its cells,
/// because the other nodes turn cells into metres by the lab's; its obstacles may differ.
/// @param weights  of the planner, if it needs some
/// @throws MissionFailure (BAD_REQUEST)
Mission readMission(const sylph_msgs::ExecuteMissionGoal& goal, const sylph::Experiment& lab,
                    Weights& weights);

}  // namespace sylph_planner_node
