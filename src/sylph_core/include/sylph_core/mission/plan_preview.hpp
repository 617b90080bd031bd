#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/checked_plan.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_core/mission/mission_lifecycle.hpp"
#include "sylph_core/mission/start_cells.hpp"

namespace sylph {

/// Plans that are looked at before anybody moves: a client asks for one, it is made as soon as all
/// poses are known, and the last one is kept, so that what was shown is what is carried out.
///
/// It is told what happens and when [s, steady], as MissionLifecycle.
class PlanPreview {
 public:
  /// What the client that asked last waits for.
  enum class Stage {
    Idle,      ///< nobody waits
    Starting,  ///< for poses, or for a plan to be finished that nobody waits for any more
    Planning,  ///< for its plan
  };

  /// A plan that is to be made.
  struct PlanningTask {
    std::function<PlanningOutcome()> make;  ///< may be called in any thread, once
    std::vector<std::string> ignored;       ///< robots that are not seen, a line each
  };

  /// @param lab  robots that there are, with part in a mission or not
  PlanPreview(std::vector<RobotSpec> lab, const MissionLimits& limits)
      : lab_(std::move(lab)), limits_(limits) {}

  /// A client asks for a plan, in place of the one that asked before and of what is shown.
  void ask(Mission mission, double now_s);
  /// The client waits no more.
  void cancel();

  /// @param poses                 needed in stage Starting
  /// @param is_mission_under_way  then nothing is planned: robots do not stand where they start
  /// @return a plan to be made, its outcome for onPlanned(); nothing most times
  std::optional<PlanningTask> tick(const RobotPoses& poses, bool is_mission_under_way,
                                   double now_s);
  /// The outcome of the last PlanningTask; one that nobody waits for any more is dropped.
  void onPlanned(PlanningOutcome outcome);

  /// What the client is told that waits: a plan, which is then the one shown, or why there is none.
  /// Given once.
  std::optional<PlanningOutcome> takeAnswer() { return std::exchange(answer_, std::nullopt); }

  Stage stage() const { return stage_; }
  /// Why there is no plan yet, for the operator; empty while one is made.
  const std::string& waitsFor() const { return waits_for_; }

  /// The number of the plan that is shown, or was shown last; 0: none yet.
  std::uint32_t number() const { return number_; }
  /// The mission that was asked for last.
  const Mission& mission() const { return mission_; }
  /// The plan of a number, for the mission that is to carry it out.
  /// @throws MissionFailure (BadRequest) if it is not shown, or of another mission
  CheckedPlan planOf(std::uint32_t number, const Mission& mission) const;
  /// Takes the plan back that is shown.
  void withdraw() { shown_.reset(); }

 private:
  bool hasWaitedForPoses(double now_s) const { return now_s - since_s_ > limits_.pose_wait_s; }
  std::optional<PlanningTask> startPlanning(const RobotPoses& poses, double now_s);
  void answer(PlanningOutcome outcome);

  std::vector<RobotSpec> lab_;
  MissionLimits limits_;
  Stage stage_ = Stage::Idle;
  Mission mission_;
  double since_s_ = 0.0;      ///< when it was asked for
  bool is_planning_ = false;  ///< for this client or one that waits no more
  std::string waits_for_;
  std::optional<PlanningOutcome> answer_;
  std::uint32_t number_ = 0;
  std::optional<CheckedPlan> shown_;
};

}  // namespace sylph
