#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "sylph_core/adg/action_dependency_graph.hpp"
#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/adg/plan_admission.hpp"
#include "sylph_core/adg/robot_monitor.hpp"
#include "sylph_core/execution/execution_event.hpp"
#include "sylph_core/execution/task_order.hpp"

namespace sylph {

/// Carries a plan out: decides which task goes to which robot when, whatever is lost, late or
/// doubled on the way, and what to do about robots that fail. Whether a plan may start is decided
/// by PlanAdmission; what is known of it all is told by explain().
///
/// Values in, values out: the caller passes what arrives and the time, then takes the events, which
/// it has to log before it sends the orders, so that a restart never forgets a task that a robot
/// has.
class Execution {
 public:
  /// @param robots  names of all robots of the lab; their order is the index used everywhere here
  /// @param rows, cols  size of the map. Its obstacles are the planner's business: a mission may
  /// have others than the lab
  /// @param corner  lower left corner of the map [m]
  Execution(std::vector<std::string> robots, int rows, int cols, double cell_size_m,
            const ExecutionLimits& limits, const Point& corner = {});

  /// Takes a plan. It starts, or is refused, as soon as that can be decided: at once if all its
  /// robots have reported and rest. What is being carried out gives way to a new mission. A plan
  /// that is known already, or older, changes nothing.
  void submit(MissionPlan plan, double now_s);
  /// Refuses a plan that cannot even be read, unless it is known already, or older.
  void refuse(std::uint32_t plan_id, const std::string& reason);
  /// @throws std::out_of_range if there is no such robot
  void report(int robot, const RobotReport& report, double now_s);
  /// Lets robots run, pause or stop; `reason` is shown to the operator. A pause leaves robots that
  /// are stopped as they are.
  /// @return false if they may not run since the emergency stop is pressed
  bool setMode(ExecutionMode mode, const std::string& reason);
  /// Pressed it stops all robots, and nobody lets them run before it is released. Not part of the
  /// events: whoever presses it says so again after a restart.
  void setEmergencyStop(bool is_pressed, const std::string& reason);
  /// Takes a robot out of the mission. Nothing happens if it is out already.
  void declareLost(int robot, const std::string& reason);
  /// Watchdogs and whatever waits for time to pass; to be called at 10 Hz or more.
  void tick(double now_s);

  /// Brings back the state that an event left, without judging it again.
  /// @throws std::invalid_argument if the event cannot follow the ones before it
  void replay(const ExecutionEvent& event);

  /// Events since the last call, in order.
  std::vector<ExecutionEvent> takeEvents();
  /// Tasks to send now: new ones, and those that a robot has not confirmed in time.
  std::vector<TaskOrder> takeOrders(double now_s);

  /// How far the plan is.
  ExecutionPhase phase() const { return phase_; }
  /// Whether robots may run, pause or have to stop.
  ExecutionMode mode() const { return mode_; }
  /// Why they pause or stop; empty while they run.
  const std::string& modeReason() const { return mode_reason_; }
  /// Why the plan was refused, why robots pause or stop, or what a pending plan waits for.
  const std::string& message() const {
    const std::string& present = mode_reason_.empty() ? wait_reason_ : mode_reason_;
    return refusal_.empty() ? present : refusal_;
  }
  /// The plan that is pending, carried out, or was refused last; 0: none yet.
  std::uint32_t planId() const { return plan_id_; }
  /// The largest plan id in plans and reports: a new plan's has to be greater.
  std::uint32_t lastPlanId() const { return last_plan_id_; }
  /// Whose tasks robots may carry out; 0: of none.
  std::uint32_t executedPlanId() const { return plan_ ? plan_->plan_id : 0; }
  /// Whether no more is released before a replacement plan starts.
  bool isCut() const { return is_cut_; }
  /// Whether a plan is carried out, be it on the way to the cut or there.
  bool isUnderWay() const;

  /// The robot that has to turn and drive to the middle of its cell, before the pending plan
  /// starts.
  std::optional<int> aligned() const {
    return aligned_ ? std::make_optional(static_cast<int>(*aligned_)) : std::nullopt;
  }

  /// Nothing before the first plan.
  const MissionPlan* plan() const { return plan_.get(); }
  /// Its agents are the robots of the lab, all of them; nothing before the first plan.
  const ActionDependencyGraph* graph() const { return graph_ ? &*graph_ : nullptr; }
  /// Robots of the mission, lost ones included, and where it wants them.
  const std::map<int, Cell>& missionGoals() const { return mission_goals_; }

  int robotCount() const { return static_cast<int>(names_.size()); }
  const std::string& name(int robot) const { return names_.at(index(robot)); }
  /// Nothing if no robot of the lab has that name.
  std::optional<int> indexOf(const std::string& name) const;
  /// Its index among the robots of plan(); nothing if it takes no part in that.
  std::optional<AgentId> agentOf(int robot) const;
  /// Of the map, between cells and metres.
  const CellFrame& frame() const { return frame_; }
  /// The watchdogs of one robot, with its last report.
  const RobotMonitor& monitor(int robot) const { return monitors_.at(index(robot)); }
  /// Where this plan's tasks begin in the graph's counting.
  int firstSequence(int robot) const { return deliveries_.at(index(robot)).first_sequence; }
  /// Since when the robot waits for another one's task, as of the last tick().
  std::optional<double> waitsSince(int robot) const { return deliveries_.at(index(robot)).waits_s; }

 private:
  /// How far this plan's tasks are on their way to a robot.
  struct Delivery {
    int first_sequence = 0;
    int accepted = 0;                           ///< tasks that it has without a gap
    std::vector<std::optional<double>> sent_s;  ///< per task, when it was sent last
    std::optional<double> waits_s;
  };
  struct Replay;

  static std::size_t index(int robot) { return static_cast<std::size_t>(robot); }
  template <typename Event>
  void log(Event event) {
    events_.emplace_back(plan_id_, std::move(event));
  }
  template <typename Event>
  void logOfPlan(Event event) {
    events_.emplace_back(plan_->plan_id, std::move(event));
  }
  void setPhase(ExecutionPhase phase);

  bool isNew(std::uint32_t plan_id) const;
  bool leadsALostRobot(const MissionPlan& plan) const;
  void makeRoomFor(std::uint32_t plan_id);
  void setRefused(std::uint32_t plan_id, const std::string& reason);
  PresentExecution present() const { return {plan_.get(), graph(), is_cut_, monitors_, aligned_}; }
  /// @return whether the pending plan has been started or refused
  bool tryStart(double now_s);
  void align(const PlanAdmission::Decision& decision, double now_s);
  void load(std::shared_ptr<const MissionPlan> plan);
  void loadMission(const MissionPlan& plan);
  void loadReplacement(const MissionPlan& plan);

  /// @return whether the robot has done more
  bool takeCounts(int robot, const RobotReport& report, double now_s);
  void updateConditions(double now_s);
  void updateWaits(double now_s);
  /// Releases what may be released and moves the phase on.
  void advance();
  void release(const std::vector<AgentId>& lost);
  std::vector<AgentId> lostRobots() const;
  /// Whether a task was released to the robot and is not done.
  bool hasReleased(int robot) const;
  /// Tasks of this plan that were released to the robot, done or not.
  int releasedCount(int robot) const;
  TaskId taskOf(int robot, int sequence) const;

  std::vector<std::string> names_;
  std::unordered_map<std::string, int> indices_;  ///< by name
  CellFrame frame_;
  ExecutionLimits limits_;
  PlanAdmission admission_;
  std::vector<RobotMonitor> monitors_;
  std::vector<Delivery> deliveries_;
  std::set<int> undelivered_;  ///< robots that may lack a task which is released to them

  ExecutionPhase phase_ = ExecutionPhase::Idle;
  ExecutionMode mode_ = ExecutionMode::Run;
  std::string mode_reason_;
  bool is_emergency_ = false;  ///< the emergency stop is pressed
  std::string refusal_;
  std::string wait_reason_;  ///< of the plan that is pending
  std::optional<std::size_t> aligned_;
  std::uint32_t plan_id_ = 0;
  std::uint32_t last_plan_id_ = 0;
  bool is_cut_ = false;
  bool is_abandoned_ = false;  ///< no more is released: a new mission takes the plan's place
  std::shared_ptr<const MissionPlan> plan_;
  std::optional<ActionDependencyGraph> graph_;
  std::unordered_map<int, AgentId> agents_;  ///< of the plan's robots
  std::map<int, Cell> mission_goals_;
  std::vector<ExecutionEvent> events_;
};

}  // namespace sylph
