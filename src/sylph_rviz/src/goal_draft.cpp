#include "sylph_rviz/goal_draft.hpp"

#include <limits>
#include <optional>
#include <utility>

#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_core/mission/goal_judge.hpp"
#include "sylph_core/mission/mission.hpp"

namespace sylph_rviz {
namespace {

sylph::Cell nearestFreeCell(const sylph::Grid& grid, const sylph::CellFrame& frame,
                            const sylph::Point& point) {
  const sylph::Cell cell = frame.toCell(point);
  if (!grid.isInside(cell) || grid.isFree(cell)) {
    return cell;
  }
  sylph::Cell nearest = cell;
  double least_m = std::numeric_limits<double>::infinity();
  for (const sylph::Cell& free : grid.freeCells()) {
    const double distance_m = sylph::distance(frame.toPoint(free), point);
    if (distance_m < least_m) {
      least_m = distance_m;
      nearest = free;
    }
  }
  return nearest;
}

}  // namespace

GoalDraft::GoalDraft(sylph::Experiment lab)
    : lab_(std::move(lab)), bystander_distance_m_(bystanderDistance(lab_)) {}

bool GoalDraft::hasPart(const std::string& robot) const {
  return others_give_way_ || goals_.count(robot) != 0;
}

GoalDraft::Proposal GoalDraft::propose(const std::string& robot, const sylph::Point& point,
                                       const sylph::RobotPoses& poses) const {
  const sylph::CellFrame frame = cellFrameOf(lab_);
  Proposal proposal;
  proposal.cell = nearestFreeCell(lab_.grid, frame, point);
  sylph::Mission mission;
  mission.grid = lab_.grid;
  mission.cell_size_m = lab_.cell_size_m;
  mission.corner = lab_.corner;
  sylph::CellOwners taken;
  std::optional<sylph::Cell> start;
  for (const std::string& name : namesOf(lab_)) {
    if (name == robot || hasPart(name)) {
      mission.robots.push_back(name);
    }
    const auto pose = poses.find(name);
    std::optional<sylph::Cell> cell;
    if (pose != poses.end() && pose->second.fault.empty()) {
      cell = frame.toCell(sylph::position(pose->second.pose));
    }
    if (name == robot) {
      start = cell && lab_.grid.isInside(*cell) ? cell : std::nullopt;
    } else if (const auto goal = goals_.find(name); goal != goals_.end()) {
      taken.emplace(goal->second, name);
    } else if (cell && others_give_way_) {
      taken.emplace(*cell, name);  // it comes back
    }
  }
  if (start && proposal.cell == *start && taken.count(proposal.cell) == 0) {
    return proposal;  // it stays: no goal at all
  }
  const sylph::GoalJudge judge(
      lab_.grid, cellsOfBystanders(mission, lab_.robots, poses, bystander_distance_m_));
  proposal.refusal = judge.refusal(robot, proposal.cell, start, taken);
  return proposal;
}

GoalDraft::Proposal GoalDraft::set(const std::string& robot, const sylph::Point& point,
                                   const sylph::RobotPoses& poses) {
  Proposal proposal = propose(robot, point, poses);
  if (!proposal.refusal.empty()) {
    return proposal;
  }
  const auto pose = poses.find(robot);
  const bool stays = pose != poses.end() && pose->second.fault.empty() &&
                     cellFrameOf(lab_).toCell(sylph::position(pose->second.pose)) == proposal.cell;
  if (stays) {
    goals_.erase(robot);
  } else {
    goals_[robot] = proposal.cell;
  }
  return proposal;
}

std::string GoalDraft::headline() const {
  return goals_.empty() ? "" : headlineOf(goals_, lab_.robots.size(), others_give_way_);
}

sylph::Experiment GoalDraft::experiment(const sylph::RobotPoses& poses) const {
  return withGoals(lab_, goals_, startCells(toMission(lab_), poses));
}

sylph::Experiment GoalDraft::mission(const sylph::RobotPoses& poses) const {
  const sylph::Experiment part = withParticipants(lab_, goals_, others_give_way_);
  return withGoals(part, goals_, startCells(toMission(part), poses));
}

}  // namespace sylph_rviz
