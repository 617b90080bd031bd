#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/execution/robot_report.hpp"
#include "sylph_core/execution/task_order.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_rehearsal/rehearsal.hpp"
#include "sylph_sim/simulation.hpp"

namespace sylph_rehearsal {

/// Sees the truth of the simulated lab, and every message as it is sent, and says what must never
/// happen. It knows the plan itself and none of the classes that carry it out.
class Oracle {
 public:
  /// @param experiment  has to outlive it
  explicit Oracle(const sylph::Experiment& experiment);

  /// A plan is carried out from now on.
  void onStarted(const sylph::MissionPlan& plan);
  /// The central node sends a task.
  void onOrder(const sylph::TaskOrder& order, double time_s);
  /// A robot tells of itself, whether anybody hears it or not.
  /// @param place  where it truly is
  void onReport(std::size_t index, const sylph::RobotReport& report, const sylph::Point& place,
                double time_s);
  /// A robot hears that it has to stop.
  void onStopHeard(std::size_t robot, double time_s);
  /// A robot's node ends: what starts again knows of no stop.
  void onNodeDown(std::size_t robot) { robots_[robot].stopped_s.reset(); }
  /// The operator lets the robots go on.
  void onResumed();
  /// Something pushes the robot: where it then is, is not its own doing.
  void onPushed(std::size_t robot) { robots_[robot].is_pushed = true; }

  /// After each step of the simulation.
  void check(const sylph_sim::Simulation& simulation, double time_s);

  const std::vector<Violation>& violations() const { return violations_; }

 private:
  /// A robot, its way in the plan that is carried out, and how far it has truly come.
  struct Robot {
    std::vector<sylph::Cell> way;     ///< cells of its tasks, where it starts first
    int done = 0;                     ///< tasks done
    std::optional<double> stopped_s;  ///< since when it knows that it has to stop
    bool is_pushed = false;
    sylph::Point place;
  };
  /// A robot leaves a cell for good, or comes back to it later.
  struct Leave {
    sylph::Timestep timestep;
    std::size_t robot;
    int sequence;
  };

  void violate(double time_s, const std::string& what) { violations_.push_back({time_s, what}); }
  const std::string& name(std::size_t robot) const { return experiment_->robots[robot].name; }
  void checkPlace(std::size_t index, double time_s);
  void checkRest(std::size_t index, const sylph::Point& before, double step_s, double time_s);

  const sylph::Experiment* experiment_;
  sylph::CellFrame frame_;
  std::vector<Robot> robots_;
  std::uint32_t plan_id_ = 0;
  std::map<sylph::Cell, std::vector<Leave>> leaves_;
  std::uint32_t collisions_ = 0;
  std::uint32_t obstacle_entries_ = 0;
  std::vector<Violation> violations_;
};

}  // namespace sylph_rehearsal
