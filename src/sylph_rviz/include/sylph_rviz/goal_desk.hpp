#pragma once

#include <sylph_msgs/ExecuteMissionResult.h>

#include <optional>
#include <string>

#include "sylph_rviz/goal_draft.hpp"
#include "sylph_rviz/shapes.hpp"

namespace sylph_rviz {

/// Why a command cannot be given, for the operator; empty: it can be.
using Refusal = std::string;

/// Goals set by hand, from the first one to the mission: which are set, what was planned of them,
/// and whether that still holds.
class GoalDesk {
 public:
  /// The lab whose robots can be sent; nothing: it is not known. Takes all goals back.
  /// @throws std::runtime_error if its robots have no safety margin
  void setLab(std::optional<sylph::Experiment> lab);

  /// A goal is being dragged: shows what letting it go would come to.
  void drag(const std::string& robot, const sylph::Point& point, const sylph::RobotPoses& poses);
  /// A goal is set, or refused. Needs a lab.
  /// @return what has become of it, in one line
  std::string set(const std::string& robot, const sylph::Point& point,
                  const sylph::RobotPoses& poses);
  /// Takes all goals back, and the plan.
  void clear();
  /// As GoalDraft::setOthersGiveWay().
  void setOthersGiveWay(bool others_give_way);

  /// The goals that are set now have been sent to be planned.
  void onSent();
  /// How planning has ended.
  void onPlanned(const sylph_msgs::ExecuteMissionResult& result);

  /// Nothing without a lab.
  const std::optional<GoalDraft>& draft() const { return draft_; }
  /// Number of the shown plan if it is of the goals that are set now, else 0.
  std::uint32_t shownPlan() const;
  /// What is to be said of the goals and the plan, in one line; empty: nothing.
  std::string text() const;
  /// Why there is nothing to plan; empty: there is.
  Refusal plan() const;
  /// Why there is nothing to carry out; empty: there is.
  Refusal go() const;

  /// The goals, and the one that is being dragged with the reason why it is refused.
  Markers markers(const Scene& scene) const;

 private:
  struct Hover {
    std::string robot;
    GoalDraft::Proposal proposal;
  };
  struct Planned {
    sylph::RobotGoals goals;
    bool others_give_way = false;
    std::optional<sylph_msgs::ExecuteMissionResult> result;  ///< nothing: not yet
  };

  bool isOfPlan() const;

  std::optional<GoalDraft> draft_;
  std::optional<Hover> hover_;
  std::optional<Planned> planned_;
};

}  // namespace sylph_rviz
