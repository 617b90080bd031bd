#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/adg/action_dependency_graph.hpp"
#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/adg/robot_monitor.hpp"
#include "sylph_core/execution/execution_event.hpp"
#include "sylph_core/execution/robot_view.hpp"
#include "sylph_core/execution/task_order.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph {

/// Carries a plan out: decides which task goes to which robot when, whatever is lost, late or
/// doubled on the way, and what to do about robots that fail.
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
  void setMode(ExecutionMode mode, const std::string& reason);
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

  ExecutionPhase phase() const { return phase_; }
  ExecutionMode mode() const { return mode_; }
  /// Why the plan was refused, or why robots pause or stop.
  std::string message() const { return refusal_.empty() ? mode_reason_ : refusal_; }
  /// The plan that is received, carried out, or was refused last; 0: none yet.
  std::uint32_t planId() const { return plan_id_; }
  /// The largest plan id in plans and reports: a new plan's has to be greater.
  std::uint32_t lastPlanId() const { return last_plan_id_; }
  /// Nothing before the first plan.
  const MissionPlan* plan() const { return plan_.get(); }
  const ActionDependencyGraph* graph() const { return graph_ ? &*graph_ : nullptr; }

  int robotCount() const { return static_cast<int>(robots_.size()); }
  const std::string& name(int robot) const { return names_.at(index(robot)); }
  std::optional<int> indexOf(const std::string& name) const;
  const RobotMonitor& monitor(int robot) const { return robots_.at(index(robot)).monitor; }
  RobotView view(int robot, double now_s) const;
  /// Robots of the mission, lost ones included, and those of them that are where it sends them.
  int missionRobots() const { return static_cast<int>(mission_goals_.size()); }
  int arrivedRobots() const;

 private:
  struct Robot {
    RobotMonitor monitor;
    int first_sequence = 0;                     ///< of this plan's tasks, in the graph's counting
    int accepted = 0;                           ///< tasks of this plan that it has without a gap
    std::vector<std::optional<double>> sent_s;  ///< per task of this plan, when it was sent last
    std::optional<double> waits_since_s;
  };

  static std::size_t index(int robot) { return static_cast<std::size_t>(robot); }
  void log(ExecutionEvent event) { events_.push_back(std::move(event)); }
  void setPhase(ExecutionPhase phase);
  void advance();

  bool isNew(std::uint32_t plan_id) const;
  void setRefused(std::uint32_t plan_id, const std::string& reason);

  // Starting a plan: execution_start.cpp
  void makeRoomFor(std::uint32_t plan_id);
  void tryStart(double now_s);
  std::optional<std::string> faultOf(const MissionPlan& plan) const;
  std::optional<std::string> reasonToWait(double now_s) const;
  std::optional<std::string> reasonNotAtStart(const MissionPlan& plan) const;
  void load(std::shared_ptr<const MissionPlan> plan);
  void loadMission(const MissionPlan& plan);
  void loadReplacement(const MissionPlan& plan);

  void takeCounts(int robot, const RobotReport& report, double now_s);
  TaskId taskOf(const ExecutionEvent& event) const;
  void updateConditions(double now_s);
  void updateWaits(double now_s);
  std::vector<AgentId> lostRobots() const;
  bool isUnderWay() const;
  /// Whether a task was released to the robot and is not done.
  bool hasReleased(int robot) const;
  /// Tasks of this plan that were released to the robot, done or not.
  int releasedCount(int robot) const;
  void fillTask(int robot, RobotView& view) const;
  void fillSocialState(int robot, RobotView& view) const;
  void fillWait(int robot, double now_s, RobotView& view) const;
  std::string whyNotMoving(int robot, double now_s) const;

  std::vector<std::string> names_;
  int rows_;
  int cols_;
  CellFrame frame_;
  ExecutionLimits limits_;
  std::vector<Robot> robots_;

  ExecutionPhase phase_ = ExecutionPhase::Idle;
  ExecutionMode mode_ = ExecutionMode::Run;
  std::string mode_reason_;
  std::string refusal_;
  std::uint32_t plan_id_ = 0;
  std::uint32_t last_plan_id_ = 0;
  bool is_cut_ = false;        ///< no more is released before a replacement plan starts
  bool is_abandoned_ = false;  ///< no more is released: a new mission takes the plan's place
  std::shared_ptr<const MissionPlan> plan_;
  std::optional<ActionDependencyGraph>
      graph_;                          ///< its agents are the robots of the lab, all of them
  std::map<int, Cell> mission_goals_;  ///< of the robots of the mission
  std::shared_ptr<const MissionPlan> pending_;
  double pending_until_s_ = 0.0;
  std::vector<ExecutionEvent> events_;
};

}  // namespace sylph
