#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sylph_core/adg/action_dependency_graph.hpp"
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
                const ExecutionLimits& limits);

  /// Keeps a plan for decide(), in place of another one that waits.
  /// @return what is wrong with it whatever the robots do: it is then not kept
  std::optional<std::string> propose(MissionPlan plan, const PresentExecution& present,
                                     double now_s);
  void withdraw() { pending_.reset(); }
  /// The plan that waits.
  const MissionPlan* pending() const { return pending_.get(); }

  struct Decision {
    enum class Verdict { Wait, Start, Refuse };
    Verdict verdict = Verdict::Wait;
    std::string reason;  ///< why it waits or is refused
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
  std::optional<std::string> reasonNotNew(const PresentExecution& present) const;
  /// Why a robot with this pose may not start in a cell, to follow its name.
  std::optional<std::string> reasonNotIn(const Cell& start, const Pose2d& pose) const;
  std::optional<std::string> reasonNotAtStart(const PresentExecution& present) const;
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
