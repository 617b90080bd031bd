#pragma once

#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/robot_goals.hpp"
#include "sylph_core/mission/start_cells.hpp"

namespace sylph_rviz {

/// Goals that an operator sets one by one, until they are planned.
class GoalDraft {
 public:
  /// Where a robot would be sent, and why it cannot be.
  struct Proposal {
    sylph::Cell cell;     ///< the free cell next to where the operator points
    std::string refusal;  ///< in one line; empty: it can be sent there
  };

  /// @param lab  its robots and its map
  /// @throws std::runtime_error if its robots have no safety margin
  explicit GoalDraft(sylph::Experiment lab);

  /// What setting a goal at `point` of frame `map` would come to. A point outside the map is
  /// refused.
  /// @param poses  of the robots, as far as they are known
  Proposal propose(const std::string& robot, const sylph::Point& point,
                   const sylph::RobotPoses& poses) const;
  /// Sets it, unless it is refused. The cell in which the robot is takes its goal back.
  Proposal set(const std::string& robot, const sylph::Point& point, const sylph::RobotPoses& poses);
  /// Takes all goals back.
  void clear() { goals_.clear(); }
  /// Whether robots without a goal may step aside and come back; otherwise they are obstacles.
  void setOthersGiveWay(bool others_give_way) { others_give_way_ = others_give_way; }

  /// As it was set.
  bool othersGiveWay() const { return others_give_way_; }
  /// Those that are set.
  const sylph::RobotGoals& goals() const { return goals_; }
  /// "robot_0 to (0,4); 7 robots stay"; empty without goals.
  std::string headline() const;

  /// An experiment of all robots of the lab, from where they are; those without a goal stay.
  /// @throws sylph::MissionFailure (NoPose) if it is not known where
  sylph::Experiment experiment(const sylph::RobotPoses& poses) const;
  /// The same of the robots that have part in the mission.
  /// @throws sylph::MissionFailure (NoPose) if it is not known where these are
  sylph::Experiment mission(const sylph::RobotPoses& poses) const;

 private:
  bool hasPart(const std::string& robot) const;

  sylph::Experiment lab_;
  double bystander_distance_m_;
  sylph::RobotGoals goals_;
  bool others_give_way_ = false;
};

}  // namespace sylph_rviz
