#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>
#include <sylph_msgs/ExecuteMissionAction.h>
#include <sylph_msgs/JointActions.h>

#include <cstdint>
#include <future>
#include <optional>
#include <string>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/checked_plan.hpp"
#include "sylph_core/mission/mission_lifecycle.hpp"
#include "sylph_planner_node/mission_request.hpp"
#include "sylph_planner_node/options.hpp"
#include "sylph_planner_node/pose_listener.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// The action `plan_mission`: plans that are looked at before anybody moves. It keeps the last one,
/// so that what was shown is what is carried out.
///
/// All callbacks run in the thread that spins.
class PlanServer {
 public:
  /// @param lab, weights  must outlive this object
  PlanServer(const ros::NodeHandle& nh, const Options& options, const sylph::Experiment& lab,
             Weights& weights, const sylph_ros::SteadyClock& clock);

  /// Is to be called regularly.
  /// @param is_mission_under_way  then nothing is planned: robots do not stand where they start
  void tick(bool is_mission_under_way);

  /// The plan of a number, for the mission that is to carry it out.
  /// @throws sylph::MissionFailure (BadRequest) if it is not known, or of another mission
  sylph::CheckedPlan planOf(std::uint32_t number, const sylph::Mission& mission) const;

  /// Takes the plan back that is shown.
  void withdraw();

 private:
  using Server = actionlib::SimpleActionServer<sylph_msgs::ExecuteMissionAction>;

  void onGoal();
  void onPreempt();
  void start();
  bool hasWaitedForPoses() const;
  void onPlanned(sylph::PlanningOutcome outcome);
  void fail(const sylph::MissionFailure& failure);
  void publishFeedback(const std::string& phase);

  Options options_;
  const sylph::Experiment& lab_;
  Weights& weights_;
  sylph_ros::SteadyClock clock_;
  PoseListener poses_;
  ros::Publisher publisher_;
  std::optional<sylph::Mission> wanted_;  ///< whose plan a client waits for
  double wanted_since_s_ = 0.0;
  double feedback_sent_s_ = 0.0;
  std::string waits_for_;
  std::future<sylph::PlanningOutcome> planning_;  ///< a plan that is being made
  bool is_for_wanted_ = false;                    ///< whether that client waits for it

  std::uint32_t number_ = 0;  ///< of the last plan, 0: none yet
  sylph::Mission shown_mission_;
  std::optional<sylph::CheckedPlan> shown_plan_;
  Server server_;
};

}  // namespace sylph_planner_node
