// The separation monitor as the last line: nothing coordinates the robots.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "bridge.hpp"
#include "monitor.hpp"
#include "open_lab.hpp"
#include "robot.hpp"
#include "sylph_core/experiment/experiment_control.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_rehearsal/link.hpp"
#include "sylph_sim/simulation.hpp"

namespace sylph_rehearsal {
namespace {

constexpr double kStart_s = 1000.0;

/// Bases, cameras, bridge, the robots' nodes and the monitor; tasks are given by the test.
class Uncoordinated {
 public:
  explicit Uncoordinated(const sylph::Experiment& experiment)
      : experiment_(experiment),
        queue_(kStart_s),
        simulation_({}, experiment_, kStart_s),
        setup_{controllerOptionsFor(experiment_.execution), 10.0, experiment_.grid,
               cellFrameOf(experiment_)},
        link_(queue_, {}, sylph::Rng(experiment.seed)),
        bridge_(experiment_.robots.size(),
                [this](std::size_t robot, const sylph::Pose2d& pose, double stamp_s) {
                  link_.send([this, robot, pose, stamp_s] {
                    robots_[robot]->onPose(pose, stamp_s);
                    monitor_.onPose(static_cast<int>(robot), pose, stamp_s);
                  });
                }),
        monitor_(footprintsOf(experiment_), separationLimits(experiment_), namesOf(experiment_),
                 queue_, [this](bool is_pressed, const std::string& /*reason*/) {
                   link_.send([this, is_pressed] {
                     for (const auto& robot : robots_) {
                       robot->onEmergencyStop(is_pressed);
                     }
                   });
                 }) {
    for (std::size_t robot = 0; robot < experiment_.robots.size(); ++robot) {
      robots_.push_back(std::make_unique<Robot>(
          setup_, queue_,
          Robot::Ports{
              [this, robot](const sylph::Twist2d& twist) { simulation_.command(robot, twist); },
              [](const sylph::RobotReport& /*report*/) {}}));
      robots_.back()->start();
    }
    bridge_.start();
    monitor_.start();
    step();
    hear();
  }

  void run(double duration_s) {
    queue_.run(queue_.now() + duration_s, [] { return true; });
  }

  /// Sends a robot along a column, whoever stands there.
  void sendNorth(std::size_t robot, sylph::Cell cell, int cells) {
    for (int task = 0; task < cells; ++task, --cell.row) {
      robots_[robot]->onTask({1, task, cell, {cell.row - 1, cell.col}});
    }
  }

  std::uint32_t collisions() const { return simulation_.collisions(); }
  double distanceDriven(std::size_t robot) const {
    const sylph::Point start = setup_.frame.toPoint(experiment_.robots[robot].start);
    return distance(start, sylph::position(simulation_.poses()[robot]));
  }

 private:
  void step() {
    for (const sylph_sim::CapturedFrame& frame : simulation_.step()) {
      bridge_.onFrame(frame, queue_.now());
    }
    queue_.after(simulation_.stepDuration(), [this] { step(); });
  }
  /// The central node runs, and says nothing of who waits for whom.
  void hear() {
    for (const auto& robot : robots_) {
      robot->onCentralState({sylph::ExecutionMode::Run, 1, queue_.now()});
    }
    queue_.after(0.1, [this] { hear(); });
  }

  sylph::Experiment experiment_;
  EventQueue queue_;
  sylph_sim::Simulation simulation_;
  RobotSetup setup_;
  Link link_;
  Bridge bridge_;
  Monitor monitor_;
  std::vector<std::unique_ptr<Robot>> robots_;
};

TEST(LastLineTest, TheMonitorAloneStopsARobotThatDrivesAtAnother) {
  int runs = 0;
  int contacts = 0;
  for (const double speed_mps : {0.1, 0.2, 0.25}) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
      sylph::Experiment experiment = openLab(7, 3, {{{6, 1}, {6, 1}}, {{1, 1}, {1, 1}}}, seed);
      experiment.execution.speed_limit_mps = speed_mps;
      Uncoordinated lab(experiment);
      lab.run(0.5);
      lab.sendNorth(0, {6, 1}, 6);
      lab.run(speed_mps < 0.15 ? 15.0 : 7.0);
      EXPECT_GT(lab.distanceDriven(0), 1.0);
      contacts += lab.collisions() > 0 ? 1 : 0;
      ++runs;
    }
  }
  EXPECT_EQ(60, runs);
  EXPECT_EQ(0, contacts);  // in 32, if robots were stopped at once and braked with 0.6 m/s^2
}

}  // namespace
}  // namespace sylph_rehearsal
