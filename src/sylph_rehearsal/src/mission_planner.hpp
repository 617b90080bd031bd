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
#include "sylph_core/planners/planner.hpp"
#include "sylph_rehearsal/event_queue.hpp"

namespace sylph_rehearsal {

/// The planner's node with one mission: all robots of the experiment to their goals, from where
/// they are seen.
class MissionPlanner {
 public:
  using PlanPort = std::function<void(const sylph::MissionPlan&)>;

  /// @param planning_s  time of the lab that planning takes
  /// @param experiment, queue  have to outlive it
  MissionPlanner(const sylph::Experiment& experiment, std::unique_ptr<sylph::Planner> planner,
                 double planning_s, EventQueue& queue, PlanPort send);

  /// The mission begins as soon as the central node and all poses are heard; or goes on, if it is
  /// under way already.
  void start();
  void crash();
  /// Sends the plan again, to a central node that has started since.
  void sendAgain();
  void onState(const sylph::AdgState& state);
  void onPose(std::size_t robot, const sylph::Pose2d& pose);

  /// Why there will be no plan; empty unless that is so.
  const std::string& failure() const { return failure_; }

 private:
  enum class Stage { Starting, Planning, Sending, Executing, Over };

  void tick(int life);
  void act();
  bool isUnderWay() const;
  void plan();
  void send();

  const sylph::Experiment* experiment_;
  sylph::CellFrame frame_;
  std::unique_ptr<sylph::Planner> planner_;
  double planning_s_;
  EventQueue* queue_;
  PlanPort send_;
  Stage stage_ = Stage::Starting;
  std::optional<sylph::AdgState> state_;
  std::vector<std::optional<sylph::Pose2d>> poses_;
  sylph::MissionPlan plan_;
  double sent_s_ = 0.0;
  std::string failure_;
  bool is_up_ = false;
  int life_ = 0;
};

}  // namespace sylph_rehearsal
