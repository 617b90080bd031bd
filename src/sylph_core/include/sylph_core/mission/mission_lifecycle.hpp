#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sylph_core/execution/adg_state.hpp"
#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/checked_plan.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_core/mission/progress.hpp"
#include "sylph_core/mission/start_cells.hpp"

namespace sylph {

/// How long things may take. All in the time that the lifecycle is told [s], > 0.
struct MissionLimits {
  double resend_period_s = 0.5;  ///< before a plan that did not arrive is sent again
  double pose_wait_s = 5.0;      ///< for poses to come when a mission starts
  double central_wait_s = 10.0;  ///< for the central node to be heard of
  double hold_wait_s = 10.0;     ///< for robots to hold after a cancellation
  /// A robot of the lab without part in the mission that is not seen within `pose_wait_s` is taken
  /// for one that stands in nobody's way.
  bool ignores_unseen_robots = false;
  /// A robot without part in the mission blocks the cells to which its footprint is so near, >= 0.
  double bystander_distance_m = 0.0;
  double replanning_time_limit_s = 1.0;  ///< wall time for a plan around lost robots
};

/// A plan, or why there is none.
using PlanningOutcome = std::variant<CheckedPlan, MissionFailure>;

/// What planning comes to. An exception that is no MissionFailure becomes one (NoPlan).
PlanningOutcome outcomeOf(const std::function<CheckedPlan()>& plan);

/// What a mission wants to be done.
namespace mission_command {

/// Takes as long as planning does: meant for a thread of its own, its outcome for onPlanned().
struct Plan {
  std::function<PlanningOutcome()> make;  ///< may be called in any thread, once
};
/// To the central node, in place of the plan before.
struct Publish {
  MissionPlan plan;
};
/// The plan that was published last.
struct PublishAgain {};
/// Takes that plan back, so that no central node that starts later finds it.
struct Withdraw {};
/// To the central node: robots finish the tasks that they have.
struct Pause {};
/// To the central node: robots go on.
struct Resume {};
/// To the operator, in the log.
struct Say {
  enum class Level { Info, Warning, Error };
  Level level = Level::Info;
  std::string text;
};
/// The mission is over.
struct End {
  MissionResult result;
};

}  // namespace mission_command

/// One thing to do, for whoever has ROS.
using MissionCommand =
    std::variant<mission_command::Plan, mission_command::Publish, mission_command::PublishAgain,
                 mission_command::Withdraw, mission_command::Pause, mission_command::Resume,
                 mission_command::Say, mission_command::End>;

/// The life of missions, one at a time: from the poses of the robots to a plan, which is sent to
/// the central node and followed; the rest is planned when robots are lost.
///
/// It is told what happens and when [s, steady], and gives out commands.
class MissionLifecycle {
 public:
  /// What the present mission waits for.
  enum class Stage {
    Idle,
    Starting,   ///< waits for poses, for the central node, for robots to hold
    Planning,   ///< a plan is being made
    Sending,    ///< the central node does not carry the plan out yet
    Executing,  ///< follows the central node
    Pausing,    ///< cancelled: waits for the robots to hold
  };

  /// @param lab          robots that there are, with part in a mission or not
  /// @param state_topic  where the central node is heard, to be named when it is not
  MissionLifecycle(std::vector<RobotSpec> lab, const MissionLimits& limits, std::string state_topic)
      : lab_(std::move(lab)), limits_(limits), state_topic_(std::move(state_topic)) {}

  /// Ends the present mission, if there is one, since another one takes its place.
  void supersede(double now_s);
  /// Only while idle.
  /// @param shown  a plan of this mission, to be carried out if it still fits; nothing: plan now
  void begin(Mission mission, double now_s, std::optional<CheckedPlan> shown = std::nullopt);
  /// Robots that are under way hold at their next cells.
  void cancel(double now_s);
  /// Ends the mission, or a request before it has become one.
  void fail(const MissionFailure& failure, double now_s);

  /// The central node was heard.
  void onAdgState(AdgState state, double now_s);
  /// The outcome of the last mission_command::Plan; one that nobody waits for any more is dropped.
  void onPlanned(PlanningOutcome outcome, double now_s);
  /// @param poses  needed in stage Starting
  void tick(const RobotPoses& poses, double now_s);

  /// What is to be done, in this order; each command is given once.
  std::vector<MissionCommand> takeCommands() { return std::exchange(commands_, {}); }

  Stage stage() const { return stage_; }
  /// For the action's feedback.
  MissionProgress progress() const;
  /// Of the present mission or the last one.
  const Mission& mission() const { return mission_; }
  /// Of the plan that was published last; 0: none yet.
  std::uint32_t planId() const { return plan_id_; }
  /// Figures of that mission so far.
  const MissionResult& totals() const { return totals_; }
  /// How the last mission ended, for the operator.
  const std::string& lastOutcome() const { return last_outcome_; }
  /// Whether any AdgState has come since the node started.
  bool hasHeardCentral() const { return state_.has_value(); }

 private:
  void tickStarting(const RobotPoses& poses, double now_s);
  void tickSending(double now_s);
  /// Whether a robot of the plan that is sent was lost after the state that it was made from.
  bool hasLostMore() const;
  void tickExecuting(double now_s);
  void tickPausing(double now_s);

  void startPlanning(const RobotPoses& poses, double now_s);
  void startReplanning(double now_s);
  void plan(mission_command::Plan command, double now_s);
  void send(const CheckedPlan& plan, double now_s);
  void sendAgain(double now_s);
  void follow(double now_s);
  void pauseIfUnderWay();
  void finish(MissionResult result, double now_s);
  void enter(Stage stage, double now_s);
  void say(mission_command::Say::Level level, const std::string& text);
  bool hasBeenSilent(double now_s) const;

  std::vector<RobotSpec> lab_;
  MissionLimits limits_;
  std::string state_topic_;
  std::vector<MissionCommand> commands_;

  Stage stage_ = Stage::Idle;
  double stage_since_s_ = 0.0;
  Mission mission_;
  std::optional<CheckedPlan> shown_plan_;
  MissionResult totals_;
  std::string last_outcome_ = "no mission yet";
  std::vector<std::string> planned_robots_;  ///< of the plan that is made, sent or carried out
  std::uint32_t plan_id_ = 0;
  std::uint32_t replaces_plan_id_ = 0;
  std::vector<std::string> given_up_;
  CellOwners bystanders_;       ///< cells of robots without part in the mission
  std::string waits_for_;       ///< why a mission does not start yet
  bool is_planning_ = false;    ///< for this mission or one that was left
  bool has_published_ = false;  ///< a plan, and has not taken it back
  bool has_paused_ = false;     ///< robots were asked to hold for the next mission
  bool lifts_pause_ = false;    ///< they ran before: the pause in force is no operator's
  double sent_s_ = 0.0;
  std::optional<AdgState> state_;  ///< the last one
  double state_received_s_ = 0.0;
};

std::string toString(MissionLifecycle::Stage stage);

}  // namespace sylph
