#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>
#include <sylph_msgs/ExecuteMissionAction.h>
#include <sylph_msgs/JointActions.h>

#include <cstdint>
#include <future>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/plan_preview.hpp"
#include "sylph_planner_node/mission_request.hpp"
#include "sylph_planner_node/options.hpp"
#include "sylph_planner_node/pose_listener.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// The action `plan_mission`, see PlanPreview, and the topic of the plan that is shown.
///
/// All callbacks run in the thread that spins.
class PlanServer {
 public:
  /// @param limits        by the clock
  /// @param lab, weights  must outlive this object
  PlanServer(const ros::NodeHandle& nh, const Options& options, const sylph::MissionLimits& limits,
             const sylph::Experiment& lab, Weights& weights, const sylph_ros::SteadyClock& clock);

  /// Is to be called regularly.
  /// @param is_mission_under_way  as PlanPreview::tick() has it
  void tick(bool is_mission_under_way);

  /// As PlanPreview::planOf().
  sylph::CheckedPlan planOf(std::uint32_t number, const sylph::Mission& mission) const {
    return preview_.planOf(number, mission);
  }

  /// Takes the plan back that is shown.
  void withdraw();

 private:
  using Server = actionlib::SimpleActionServer<sylph_msgs::ExecuteMissionAction>;

  void onGoal();
  void onPreempt();
  void answer(const sylph::PlanningOutcome& outcome);
  void show(const sylph::CheckedPlan& plan);
  void fail(const sylph::MissionFailure& failure);
  void publishFeedback();

  Options options_;
  const sylph::Experiment& lab_;
  Weights& weights_;
  sylph_ros::SteadyClock clock_;
  PoseListener poses_;
  ros::Publisher publisher_;
  sylph::PlanPreview preview_;
  std::future<sylph::PlanningOutcome> planning_;  ///< a plan that is being made
  double feedback_sent_s_ = 0.0;
  Server server_;
};

}  // namespace sylph_planner_node
