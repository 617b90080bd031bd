#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sylph_core/adg/action_dependency_graph.hpp"
#include "sylph_core/adg/alignment_room.hpp"
#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/adg/robot_monitor.hpp"
#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph {

/// What goes on while a plan asks to start.
struct PresentExecution {
  const MissionPlan* plan = nullptr;             ///< that is carried out; nothing before the first
  const ActionDependencyGraph* graph = nullptr;  ///< of that plan
  bool is_cut = false;                           ///< it waits for a replacement
  const std::vector<RobotMonitor>& monitors;     ///< one per robot of the lab
  std::optional<std::size_t> aligned;            ///< the robot that is being aligned
};

/// Decides whether a plan may start, and why not.
///
/// It may if it is of this lab, the graph and the independent checker find no fault with it, and
/// its robots have reported, rest and stand in their start cells, and nobody without part in it
/// stands in its way. For robots to report and to rest it waits.
class PlanAdmission {
 public:
  /// @param robots  names of all robots of the lab
  PlanAdmission(std::vector<std::string> robots, int rows, int cols, const CellFrame& frame,
                ExecutionLimits limits);

  /// Keeps a plan for decide(), in place of another one that waits.
  /// @return what is wrong with it whatever the robots do: it is then not kept
  std::optional<std::string> propose(MissionPlan plan, const PresentExecution& present,
                                     double now_s);
  void withdraw() { pending_.reset(); }
  /// The plan that waits has to wait for something new.
  void waitAnew(double now_s) { pending_until_s_ = now_s + limits_.start_wait_s; }
  /// The plan that waits.
  const MissionPlan* pending() const { return pending_.get(); }

  struct Decision {
    /// Align: it waits for a robot to turn and drive to the middle of its cell.
    enum class Verdict { Wait, Align, Start, Refuse };
    Verdict verdict = Verdict::Wait;
    std::string reason;     ///< why it waits or is refused
    std::size_t robot = 0;  ///< that is to be aligned
  };
  /// About the plan that waits.
  Decision decide(const PresentExecution& present, double now_s) const;
  /// Hands out the plan that waits, which then waits no more.
  std::shared_ptr<const MissionPlan> takePending() { return std::exchange(pending_, nullptr); }

 private:
  std::optional<std::size_t> indexOf(const std::string& robot) const;
  std::optional<std::string> faultOf(const MissionPlan& plan,
                                     const PresentExecution& present) const;
  std::optional<std::string> faultOfMembers(const MissionPlan& plan) const;
  std::optional<std::string> reasonToWait(const PresentExecution& present, double now_s) const;
  /// About a robot that reports; to follow its name.
  static std::optional<std::string> reasonToWaitFor(std::size_t robot,
                                                    const PresentExecution& present);
  std::optional<std::string> reasonNotNew(const PresentExecution& present) const;
  /// Why a robot with this pose may not start in a cell, to follow its name.
  std::optional<std::string> reasonNotIn(const Cell& start, const Pose2d& pose) const;
  /// How far a robot that is turned like that may be off its cell's centre, in x and y [m].
  Vector2 freedomOf(const Pose2d& pose) const;
  bool isInMiddle(const Cell& start, const Pose2d& pose) const;
  std::optional<std::string> reasonNotAtStart(const PresentExecution& present) const;
  /// Those that stand in their start cells, but off the middle; nothing if one stands elsewhere.
  std::optional<std::vector<std::size_t>> agentsToAlign(const PresentExecution& present) const;
  AlignmentQuestion alignmentOf(std::size_t agent, const PresentExecution& present) const;
  /// Nothing if no robot has to be aligned, or if that would not do.
  std::optional<Decision> decideOnAlignment(const PresentExecution& present, double now_s) const;
  std::optional<std::string> bystanderInTheWay(const PresentExecution& present) const;

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> indices_;  ///< by name
  Grid map_;  ///< free everywhere: obstacles are the planner's business
  CellFrame frame_;
  ExecutionLimits limits_;
  std::shared_ptr<const MissionPlan> pending_;
  double pending_until_s_ = 0.0;
};

}  // namespace sylph
