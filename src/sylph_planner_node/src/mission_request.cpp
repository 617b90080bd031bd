#include "sylph_planner_node/mission_request.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_core/mission/goal_judge.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/text/join.hpp"
#include "sylph_planner_node/mission_text.hpp"
#include "sylph_ros/conversions.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::ExecuteMissionGoal;

[[noreturn]] void refuse(const std::string& message) {
  throw sylph::MissionFailure(sylph::MissionOutcome::BadRequest, message);
}

std::string sizeOf(const sylph::Grid& grid) {
  return std::to_string(grid.rows()) + " x " + std::to_string(grid.cols()) + " cells";
}

sylph::Grid readMap(const ExecuteMissionGoal& goal, const sylph::Experiment& lab) {
  sylph::Grid grid;
  try {
    grid = sylph::loadMapFor(lab, goal.map);
  } catch (const std::exception& error) {
    refuse(error.what());
  }
  // Obstacles may be others than the lab's, places may not: all nodes turn cells into metres by the
  // lab's map.
  if (grid.rows() != lab.grid.rows() || grid.cols() != lab.grid.cols()) {
    refuse("map " + goal.map + " has " + sizeOf(grid) + ", the lab's map " + lab.map_path +
           " has " + sizeOf(lab.grid) + ": they must be of the same size");
  }
  if (!(std::abs(goal.cell_size_m - lab.cell_size_m) < 1e-6)) {
    refuse("cell_size_m " + std::to_string(goal.cell_size_m) + ": the lab's cells have " +
           std::to_string(lab.cell_size_m) + " m");
  }
  return grid;
}

void requireRobots(const ExecuteMissionGoal& goal, const sylph::Experiment& lab) {
  if (goal.robots.empty()) {
    refuse("a mission needs at least one robot");
  }
  if (goal.robots.size() != goal.goals.size()) {
    refuse(std::to_string(goal.robots.size()) + " robots but " + std::to_string(goal.goals.size()) +
           " goals");
  }
  const std::vector<std::string> names = namesOf(lab);
  for (auto robot = goal.robots.begin(); robot != goal.robots.end(); ++robot) {
    if (std::find(names.begin(), names.end(), *robot) == names.end()) {
      refuse(sylph::unknownRobot(*robot, names));
    }
    if (std::find(goal.robots.begin(), robot, *robot) != robot) {
      refuse("robot " + *robot + " is named twice");
    }
  }
}

void requirePlanner(const sylph::Mission& mission) {
  const std::vector<std::string>& names = sylph::plannerNames();
  if (std::find(names.begin(), names.end(), mission.planner) == names.end()) {
    refuse("unknown planner '" + mission.planner + "': allowed are " + sylph::join(names));
  }
  if (!std::isfinite(mission.time_limit_s) || mission.time_limit_s <= 0.0) {
    refuse("time_limit_s " + std::to_string(mission.time_limit_s) + ": must be > 0, or 0 for " +
           "the default");
  }
}

}  // namespace

std::shared_ptr<const sylph::Policy> Weights::of(const std::string& planner) {
  if (!sylph::needsPolicy(planner)) {
    return nullptr;
  }
  // Once in the life of the node, for all planners that need one.
  if (!policy_) {
    policy_ = sylph::loadPolicyFor(planner, path_);
  }
  return policy_;
}

sylph::Mission readMission(const ExecuteMissionGoal& goal, const sylph::Experiment& lab,
                           Weights& weights) {
  requireRobots(goal, lab);
  sylph::Mission mission;
  mission.map_path = goal.map;
  mission.grid = readMap(goal, lab);
  mission.cell_size_m = goal.cell_size_m;
  mission.corner = lab.corner;
  mission.robots = goal.robots;
  for (const sylph_msgs::Cell& cell : goal.goals) {
    mission.goals.push_back(sylph_ros::fromMessage(cell));
  }
  requireGoals(mission);
  mission.planner = goal.planner.empty() ? lab.planning.planner : goal.planner;
  mission.time_limit_s = goal.time_limit_s == 0.0 ? lab.planning.time_limit_s : goal.time_limit_s;
  mission.seed = goal.seed;
  requirePlanner(mission);
  try {
    mission.policy = weights.of(mission.planner);
  } catch (const std::exception& error) {
    refuse(error.what());
  }
  return mission;
}

}  // namespace sylph_planner_node
