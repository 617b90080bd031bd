#include "sylph_robot_node/options.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "sylph_core/experiment/experiment_control.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/parameters.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_robot_node {
namespace {

double radians(double degrees) {
  return degrees * M_PI / 180.0;
}

/// One number with its bounds; `value` holds the default.
struct Number {
  const char* name;
  double* value;
  double low;
  double high;
};

void readNumber(const ros::NodeHandle& nh, const Number& number) {
  sylph_ros::read(nh, number.name, *number.value);
  sylph_ros::requireInRange(nh, number.name, *number.value, number.low, number.high);
}

void readCount(const ros::NodeHandle& nh, const char* name, int& value) {
  sylph_ros::read(nh, name, value);
  sylph_ros::requireInRange(nh, name, value, 1, 1000);
}

std::string nameFromNamespace(const ros::NodeHandle& nh) {
  const std::string name_space = nh.getNamespace();
  return name_space.substr(name_space.rfind('/') + 1);
}

void requireMember(const sylph::Experiment& experiment, const std::string& robot) {
  std::string names;
  for (const sylph::RobotSpec& spec : experiment.robots) {
    if (spec.name == robot) {
      return;
    }
    names += (names.empty() ? "" : ", ") + spec.name;
  }
  throw std::runtime_error("robot " + robot + ": not in " + experiment.path + ", which has " +
                           names);
}

void readController(const ros::NodeHandle& nh, sylph::RobotControllerOptions& controller) {
  sylph::FollowerOptions& follower = controller.follower;
  double heading_correction_deg = 20.0;
  double pose_jump_deg = 17.0;
  const std::vector<Number> numbers = {
      {"heading_rad", &follower.heading_rad, -M_PI, M_PI},
      {"base_latency_s", &controller.base.latency_s, 0.0, 0.5},
      {"base_lag_s", &controller.base.lag_s, 0.0, 1.0},
      {"command_acceleration_mps2", &controller.limits.acceleration_mps2, 0.01, 100.0},
      {"stop_deceleration_mps2", &controller.stop_deceleration_mps2, 0.01, 100.0},
      {"slip_limit", &controller.slip.largest, 0.0, 0.5},
      {"blend_m", &follower.blend_m, 0.0, 0.1},
      {"braking_share", &follower.braking_share, 0.1, 1.0},
      {"approach_gain", &follower.approach_gain, 0.1, 50.0},
      {"cross_gain", &follower.cross.proportional, 0.0, 50.0},
      {"cross_integral_gain", &follower.cross.integral, 0.0, 50.0},
      {"cross_integral_limit_mps", &follower.cross.integral_limit, 0.0, 1.0},
      {"heading_gain", &follower.heading.proportional, 0.0, 50.0},
      {"heading_integral_gain", &follower.heading.integral, 0.0, 50.0},
      {"heading_integral_limit_radps", &follower.heading.integral_limit, 0.0, 1.0},
      {"heading_correction_deg", &heading_correction_deg, 1.0, 180.0},
      {"central_timeout_s", &controller.supervisor.central_timeout_s, 0.05, 60.0},
      {"pose_jump_m", &controller.watch.jump_m, 0.001, 10.0},
      {"pose_jump_deg", &pose_jump_deg, 0.1, 180.0},
  };
  for (const Number& number : numbers) {
    readNumber(nh, number);
  }
  readCount(nh, "good_poses", controller.watch.good_poses);
  readCount(nh, "consistent_poses", controller.watch.consistent_poses);
  readCount(nh, "arrival_poses", controller.arrival_poses);
  follower.lag_s = controller.base.lag_s;
  controller.supervisor.heading_correction_rad = radians(heading_correction_deg);
  controller.watch.jump_rad = radians(pose_jump_deg);
}

}  // namespace

Options loadOptions(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh) {
  sylph_ros::requireKnown(private_nh, {"experiment",
                                       "robot",
                                       "heading_rad",
                                       "control_rate_hz",
                                       "report_rate_hz",
                                       "shutdown_s",
                                       "base_latency_s",
                                       "base_lag_s",
                                       "command_acceleration_mps2",
                                       "stop_deceleration_mps2",
                                       "slip_limit",
                                       "blend_m",
                                       "braking_share",
                                       "approach_gain",
                                       "cross_gain",
                                       "cross_integral_gain",
                                       "cross_integral_limit_mps",
                                       "heading_gain",
                                       "heading_integral_gain",
                                       "heading_integral_limit_radps",
                                       "heading_correction_deg",
                                       "central_timeout_s",
                                       "pose_jump_m",
                                       "pose_jump_deg",
                                       "good_poses",
                                       "consistent_poses",
                                       "arrival_poses",
                                       "diagnostic_period"});
  Options options;
  options.robot = nameFromNamespace(nh);
  sylph_ros::read(private_nh, "robot", options.robot);
  std::string own_path;
  sylph_ros::read(private_nh, "experiment", own_path);
  const sylph::Experiment experiment =
      sylph_ros::loadExperiment(sylph_ros::suiteHandle(nh), own_path);
  requireMember(experiment, options.robot);
  options.grid = experiment.grid;
  options.cell_size_m = experiment.cell_size_m;
  options.corner = experiment.corner;
  options.controller = sylph::controllerOptionsFor(experiment.execution);
  readController(private_nh, options.controller);
  readNumber(private_nh, {"control_rate_hz", &options.control_rate_hz, 10.0, 500.0});
  readNumber(private_nh, {"report_rate_hz", &options.report_rate_hz, 1.0, options.control_rate_hz});
  readNumber(private_nh, {"shutdown_s", &options.shutdown_s, 0.0, 5.0});
  options.controller.period_s = 1.0 / options.control_rate_hz;
  return options;
}

}  // namespace sylph_robot_node
