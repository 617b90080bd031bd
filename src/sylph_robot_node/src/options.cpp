#include "sylph_robot_node/options.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sylph_core/experiment/experiment_control.hpp"
#include "sylph_core/text/join.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_robot_node {
namespace {

/// An angle that users see in degrees.
void readDegrees(sylph_ros::ParameterReader& reader, const char* name, double& value_rad,
                 const sylph::Range& range, const char* meaning) {
  double value_deg = value_rad * 180.0 / M_PI;
  reader.read(name, value_deg, range, meaning);
  value_rad = value_deg * M_PI / 180.0;
}

std::string nameFromNamespace(const ros::NodeHandle& nh) {
  const std::string& name_space = nh.getNamespace();
  return name_space.substr(name_space.rfind('/') + 1);
}

void requireMember(const sylph::Experiment& experiment, const std::string& robot) {
  const std::vector<std::string> names = namesOf(experiment);
  if (std::find(names.begin(), names.end(), robot) == names.end()) {
    throw std::runtime_error("robot " + robot + ": not in " + experiment.path + ", which has " +
                             sylph::join(names));
  }
}

void readBase(sylph_ros::ParameterReader& reader, sylph::RobotControllerOptions& controller) {
  reader.read("base_latency_s", controller.base.latency_s, {0.0, 0.5},
              "from `cmd_vel` to the wheels");
  reader.read("base_lag_s", controller.base.lag_s, {0.0, 1.0},
              "time constant with which the speed then follows");
  reader.read("command_acceleration_mps2", controller.limits.acceleration_mps2, {0.01, 100.0},
              "largest change of a command; more than the robot's limit, since feed-forward steps");
  reader.read("stop_deceleration_mps2", controller.stop_deceleration_mps2, {0.01, 100.0},
              "of a ramp to zero");
  reader.read("slip_limit", controller.slip.largest, {0.0, 0.5},
              "share of the speed lost by slip that is learnt and made up for, so that the robot "
              "itself keeps the speed limit");
  controller.follower.lag_s = controller.base.lag_s;
}

void readFollower(sylph_ros::ParameterReader& reader, sylph::FollowerOptions& follower) {
  const sylph::Range gain{0.0, 50.0};
  const sylph::Range limit{0.0, 1.0};
  reader.read("heading_rad", follower.heading_rad, {-M_PI, M_PI}, "yaw held all the time");
  reader.read("blend_m", follower.blend_m, {0.0, 0.1},
              "corners are rounded from so far before to so far behind the centre; below 0.001 it "
              "stops");
  reader.read("braking_share", follower.braking_share, {0.1, 1.0},
              "of the acceleration limit that braking plans with");
  reader.read("approach_gain", follower.approach_gain, {0.1, 50.0},
              "speed per distance close to a stop [1/s]");
  reader.read("cross_gain", follower.cross.proportional, gain,
              "speed per distance across the path [1/s]");
  reader.read("cross_integral_gain", follower.cross.integral, gain,
              "acceleration per distance across the path [1/s^2]");
  reader.read("cross_integral_limit_mps", follower.cross.integral_limit, limit,
              "largest speed that the integral adds");
  reader.read("heading_gain", follower.heading.proportional, gain,
              "turn rate per heading error [1/s]");
  reader.read("heading_integral_gain", follower.heading.integral, gain,
              "turn acceleration per heading error [1/s^2]");
  reader.read("heading_integral_limit_radps", follower.heading.integral_limit, limit,
              "largest turn rate that the integral adds");
}

void readWatches(sylph_ros::ParameterReader& reader, sylph::RobotControllerOptions& controller) {
  const sylph::Range count{1.0, 1000.0};
  readDegrees(reader, "heading_correction_deg", controller.supervisor.heading_correction_rad,
              {1.0, 180.0}, "a larger heading error is for an operator to correct");
  reader.read("central_timeout_s", controller.supervisor.central_timeout_s, {0.05, 60.0},
              "without AdgState for so long it finishes its task and holds");
  reader.read("pose_jump_m", controller.watch.jump_m, {0.001, 10.0},
              "a pose may be so far from where the robot was driven");
  readDegrees(reader, "pose_jump_deg", controller.watch.jump_rad, {0.1, 180.0},
              "the same for the yaw");
  reader.read("motion_aside_m", controller.motion.aside_m, {0.001, 10.0},
              "what may be measured in 0.4 s beside the way that it is driven; more stops it until "
              "its pose is confirmed");
  reader.read("motion_patience_m", controller.motion.patience_m, {0.001, 10.0},
              "commanded without moving, before it only creeps; 50 mm of that in vain stop it");
  reader.read("good_poses", controller.watch.good_poses, count,
              "in a row, before a blind robot goes on");
  reader.read("consistent_poses", controller.watch.consistent_poses, count,
              "in a row at another place, before the operator can confirm it");
  reader.read("arrival_poses", controller.arrival_poses, count, "in a row, that show an arrival");
}

}  // namespace

Options readOptions(sylph_ros::ParameterReader& reader) {
  Options options;
  reader.read("robot", options.robot,
              "name in the experiment; empty: last part of the node's namespace");
  reader.read("experiment", options.experiment,
              "absolute path of a copy of the experiment file on this computer; empty: the "
              "suite's `experiment`");
  readBase(reader, options.controller);
  reader.read("control_rate_hz", options.control_rate_hz, {10.0, 500.0}, "of the control loop");
  readFollower(reader, options.controller.follower);
  readWatches(reader, options.controller);
  reader.read("report_rate_hz", options.report_rate_hz, {1.0, 500.0},
              "of `task_report`; not above `control_rate_hz`");
  reader.read("shutdown_s", options.shutdown_s, {0.0, 5.0}, "zeros sent before the node ends");
  reader.read(
      "poses_by_udp", options.poses_by_udp,
      "over a network that loses packets: a lost pose does not hold up the next ones, as it "
      "does over TCP");
  sylph_ros::readDiagnosticPeriod(reader);
  if (options.report_rate_hz > options.control_rate_hz) {
    throw reader.error("report_rate_hz", "must be at most control_rate_hz = " +
                                             sylph::shortNumber(options.control_rate_hz));
  }
  options.controller.period_s = 1.0 / options.control_rate_hz;
  return options;
}

Options loadOptions(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh) {
  Options options = sylph_ros::readStrictly(private_nh, readOptions);
  if (options.robot.empty()) {
    options.robot = nameFromNamespace(nh);
  }
  const sylph::Experiment experiment =
      sylph_ros::loadExperiment(sylph_ros::suiteHandle(nh), options.experiment);
  requireMember(experiment, options.robot);
  options.grid = experiment.grid;
  options.cell_size_m = experiment.cell_size_m;
  options.corner = experiment.corner;
  sylph::applyExecution(experiment.execution, options.controller);
  return options;
}

}  // namespace sylph_robot_node
