#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/execution/adg_state.hpp"
#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/mission/mission_lifecycle.hpp"
#include "sylph_core/policy/policy.hpp"
#include "sylph_rehearsal/event_queue.hpp"

namespace sylph_rehearsal {

/// The planner's node with one mission: all robots of the experiment to their goals, from where
/// they are seen.
class MissionPlanner {
 public:
  struct Ports {
    std::function<void(const sylph::MissionPlan&)> plan;  ///< to the central node
    std::function<void(sylph::ExecutionMode)> mode;       ///< asked of the central node
  };

  /// @param planning_s  time of the lab that planning takes
  /// @param experiment, queue  have to outlive it
  /// @throws std::invalid_argument if the experiment's planner is unknown or needs a policy
  MissionPlanner(const sylph::Experiment& experiment, std::shared_ptr<const sylph::Policy> policy,
                 double planning_s, EventQueue& queue, Ports ports);

  /// The mission begins as soon as the central node and all poses are heard; or goes on, if it is
  /// under way already.
  void start();
  void crash();
  /// The plan that stands on the topic reaches a central node that has started since.
  void sendAgain();
  void onState(const sylph::AdgState& state);
  void onPose(std::size_t robot, const sylph::Pose2d& pose);

  /// Why the mission has ended without success; empty unless that is so.
  const std::string& failure() const { return failure_; }

 private:
  struct SeenPose {
    sylph::Pose2d pose;
    double received_s = 0.0;
  };

  void tick(int life);
  sylph::RobotPoses poses() const;
  void carryOutCommands();
  void carryOut(const sylph::mission_command::Plan& command);
  void carryOut(const sylph::mission_command::Publish& command);
  void carryOut(const sylph::mission_command::PublishAgain& /*command*/) { sendAgain(); }
  void carryOut(const sylph::mission_command::Withdraw& /*command*/) { plan_.reset(); }
  void carryOut(const sylph::mission_command::Pause& /*command*/) const;
  void carryOut(const sylph::mission_command::Resume& /*command*/) const;
  void carryOut(const sylph::mission_command::Say& /*command*/) {}
  void carryOut(const sylph::mission_command::End& command);

  const sylph::Experiment* experiment_;
  sylph::Mission mission_;
  double planning_s_;
  EventQueue* queue_;
  Ports ports_;
  std::optional<sylph::MissionLifecycle> lifecycle_;  ///< nothing while the node is down
  std::vector<std::optional<SeenPose>> poses_;
  std::optional<sylph::MissionPlan> plan_;  ///< that stands on the topic
  std::string failure_;
  int life_ = 0;
};

}  // namespace sylph_rehearsal
