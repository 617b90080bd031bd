#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "braking_meter.hpp"
#include "bridge.hpp"
#include "central.hpp"
#include "mission_planner.hpp"
#include "monitor.hpp"
#include "oracle.hpp"
#include "robot.hpp"
#include "sylph_rehearsal/event_queue.hpp"
#include "sylph_rehearsal/lab_fault.hpp"
#include "sylph_rehearsal/link.hpp"
#include "sylph_rehearsal/rehearsal.hpp"

namespace sylph_rehearsal {

/// All nodes of the lab, what is between them, and the simulated robots and cameras.
class Lab {
 public:
  Lab(sylph::Experiment experiment, const RehearsalOptions& options,
      const std::shared_ptr<const sylph::Policy>& policy, std::vector<LabFault> faults);
  Lab(const Lab&) = delete;
  Lab& operator=(const Lab&) = delete;

  /// To the end.
  Rehearsal run();

 private:
  /// The ways of one robot's messages.
  struct RobotLinks {
    Link poses;
    Link tasks;
    Link state;
    Link reports;
    Link emergency;
  };

  sylph::Rng seeded(std::uint32_t part) const;
  void makeLinks();
  void makeRobots();
  void start();
  void step();
  void onPose(std::size_t robot, const sylph::Pose2d& pose, double stamp_s);
  void onEmergencyStop(bool is_pressed, const std::string& reason);
  void onReport(std::size_t robot, const sylph::RobotReport& report);
  void onCentralState(const sylph::CentralState& state);

  void begin(const LabFault& fault);
  void end(const LabFault& fault);
  void simulate(sylph_sim::Fault fault);
  void tellOfButton();
  /// The operator walks around the robots, and confirms poses that are true.
  void lookAtRobots();
  void setLinks(const LabFault& fault, bool has_fault);
  void startCentral();
  void startRobot(std::size_t robot);
  /// As often as it takes.
  void resume(sylph::ExecutionMode mode);
  void onEvent(const sylph::ExecutionEvent& event);
  void noteWaits();
  bool goesOn();
  std::string causeOfStop() const;
  Rehearsal summary();

  sylph::Experiment experiment_;
  RehearsalOptions options_;
  EventQueue queue_;
  sylph_sim::Simulation simulation_;
  RobotSetup setup_;
  std::vector<RobotLinks> links_;
  Link to_planner_;
  Link to_central_;
  Link to_monitor_;
  std::vector<std::unique_ptr<Robot>> robots_;
  Central central_;
  Bridge bridge_;
  Monitor monitor_;
  MissionPlanner planner_;
  Oracle oracle_;
  BrakingMeter braking_;
  std::vector<LabFault> faults_;
  double progress_s_;  // when something was done last
  bool is_over_ = false;
  bool is_button_pressed_ = false;
  std::vector<double> waits_s_;  // of each robot for each other one, row by row
};

}  // namespace sylph_rehearsal
