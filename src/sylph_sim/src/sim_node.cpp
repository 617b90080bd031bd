#include "sylph_sim/sim_node.hpp"

#include <rosgraph_msgs/Clock.h>
#include <sylph_msgs/SimulationTruth.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "sylph_ros/experiment.hpp"
#include "sylph_ros/parameters.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_sim {
namespace {

/// After a hitch the robots move on at most this far before anybody can answer: one period of their
/// controllers. What is more makes simulated time run slower.
constexpr double kMaxBacklog_s = 0.02;
/// The timer ticks once a step, but not more often than this.
constexpr double kMinTimerPeriodWall = 0.001;
/// In lock step the cameras' server answers questions so often.
constexpr double kServePeriodWall = 0.01;
/// Below this share of the speed asked for the node says so.
constexpr double kLowSpeedShare = 0.9;

sylph_natnet::ServerOptions serverOptions(const Options& options, bool is_in_lock_step) {
  sylph_natnet::ServerOptions server;
  if (is_in_lock_step) {
    server.client_timeout = std::chrono::hours(1);  // time may stand still for long
  }
  server.address = options.natnet.address;
  server.command_port = static_cast<std::uint16_t>(options.natnet.command_port);
  server.data_port = static_cast<std::uint16_t>(options.natnet.data_port);
  server.multicast = options.natnet.multicast;
  server.multicast_group = options.natnet.multicast_group;
  server.name = "sylph_sim";
  server.version = options.natnet.version;
  server.ticks_per_s = kTicksPerSecond;
  server.frame_rate_hz = static_cast<float>(options.simulation.cameras.rate_hz);
  return server;
}

/// Without simulated time the stamps of all other nodes would tell another time than /clock.
void requireSimulatedTime() {
  bool use_sim_time = false;
  ros::NodeHandle nh;
  sylph_ros::read(nh, "/use_sim_time", use_sim_time);
  if (!use_sim_time) {
    throw std::runtime_error("parameter " + nh.resolveName("/use_sim_time") +
                             ": must be true with the simulator");
  }
}

bool isInLockStep(const ros::NodeHandle& nh) {
  bool is_in_lock_step = false;
  sylph_ros::read(nh, sylph_ros::kLockStepParameter, is_in_lock_step);
  return is_in_lock_step;
}

/// Only in lock step is there a speed of 0, which is as fast as it goes.
double readSpeed(const ros::NodeHandle& nh, bool is_in_lock_step) {
  double speed = 1.0;
  sylph_ros::read(nh, sylph_ros::kSpeedParameter, speed,
                  is_in_lock_step ? sylph::Range::atLeast(0.0) : sylph::Range::positive());
  return speed;
}

/// In lock step whole seconds, so that rounding of stamps is the same in each run.
double startTime(bool is_in_lock_step) {
  const double now_s = ros::WallTime::now().toSec();
  return is_in_lock_step ? std::floor(now_s) : now_s;
}

/// Without which a mission cannot begin.
std::vector<std::string> expectedNodes(const ros::NodeHandle& nh,
                                       const sylph::Experiment& experiment) {
  std::vector<std::string> names;
  for (const char* node : {"mocap_bridge", "sylph_adg_central", "sylph_separation_monitor",
                           "sylph_planner", "sylph_mission"}) {
    names.push_back(nh.resolveName(node));
  }
  for (const sylph::RobotSpec& robot : experiment.robots) {
    names.push_back(nh.resolveName(sylph_ros::robotTopic(nh, robot.name, "sylph_robot")));
  }
  return names;
}

}  // namespace

SimNode::SimNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
    : options_(sylph_ros::readStrictly(private_nh, readOptions)),
      experiment_(sylph_ros::loadExperiment(nh)),
      is_in_lock_step_(isInLockStep(nh)),
      target_speed_(readSpeed(nh, is_in_lock_step_)),
      start_s_(startTime(is_in_lock_step_)),
      simulation_(options_.simulation, experiment_, start_s_),
      server_(serverOptions(options_, is_in_lock_step_)),
      clock_period_s_(
          std::max(is_in_lock_step_ ? options_.lock_step.clock_period_s : options_.clock_period_s,
                   target_speed_ / options_.clock_wall_rate_limit_hz)),
      next_clock_s_(start_s_),
      next_truth_s_(start_s_),
      diagnostics_(nh, private_nh) {
  requireSimulatedTime();
  for (const Fault& fault : loadFaults(private_nh, experiment_)) {
    simulation_.schedule(fault);
  }
  server_.setDefinitions(modelDefinitions(experiment_));
  clock_publisher_ = nh.advertise<rosgraph_msgs::Clock>("/clock", 1);
  truth_publisher_ = nh.advertise<sylph_msgs::SimulationTruth>(sylph_ros::kSimulationTruthTopic, 1);
  inject_fault_server_ =
      nh.advertiseService(sylph_ros::kInjectFaultService, &SimNode::onInjectFault, this);
  diagnostics_.setHardwareID("none");
  diagnostics_.add("simulation", this, &SimNode::diagnose);
  if (is_in_lock_step_) {
    startInLockStep(nh);
  } else {
    startFreely(nh);
  }
  for (std::size_t robot = 0; robot < experiment_.robots.size(); ++robot) {
    subscribe(nh, robot);
  }
  ROS_INFO("simulating %zu robots at %s times real time%s, NatNet %s on port %u",
           experiment_.robots.size(),
           target_speed_ > 0.0 ? sylph::shortNumber(target_speed_).c_str() : "as many as it can",
           is_in_lock_step_ ? " at most, in lock step" : "",
           sylph_natnet::toString(options_.natnet.version).c_str(), server_.commandPort());
}

void SimNode::startFreely(ros::NodeHandle& nh) {
  const double step_s = simulation_.stepDuration();
  pacer_.emplace(step_s, target_speed_, kMaxBacklog_s);
  timer_ =
      nh.createSteadyTimer(ros::WallDuration(std::max(step_s / target_speed_, kMinTimerPeriodWall)),
                           &SimNode::advance, this);
}

void SimNode::startInLockStep(const ros::NodeHandle& nh) {
  const double steps = options_.lock_step.period_s / simulation_.stepDuration();
  if (std::abs(steps - std::round(steps)) > 1e-6 || steps < 0.5) {
    throw std::runtime_error("parameter " + nh.resolveName("~lock_step/period_s") + " = " +
                             sylph::shortNumber(options_.lock_step.period_s) +
                             ": must be a multiple of 1 / step_rate_hz");
  }
  lock_step_ = std::make_unique<LockStepHost>(
      nh, options_.lock_step, expectedNodes(nh, experiment_), target_speed_, ros::Time(start_s_),
      [this] { return advanceTick(); });
  // NatNet clients have to be served before the lab begins, which waits for them.
  timer_ = nh.createSteadyTimer(ros::WallDuration(kServePeriodWall),
                                [this](const ros::SteadyTimerEvent&) {
                                  server_.serve(toTicks(simulation_.time() - start_s_));
                                  if (!lock_step_->hasBegun()) {
                                    publishClock(simulation_.time());
                                  }
                                  diagnostics_.update();
                                });
}

void SimNode::subscribe(ros::NodeHandle& nh, std::size_t robot) {
  const std::string topic = nh.resolveName(
      sylph_ros::robotTopic(nh, experiment_.robots[robot].name, sylph_ros::kCommandTopic));
  using Message = geometry_msgs::TwistConstPtr;
  boost::function<void(const Message&)> handle = [this, robot](const Message& message) {
    onCommand(robot, *message);
  };
  if (lock_step_) {
    handle = [this, robot, box = lock_step_->open(topic)](const Message& message) {
      box->push([this, robot, message] { onCommand(robot, *message); });
      lock_step_->onArrival();
    };
  }
  command_subscribers_.push_back(nh.subscribe<geometry_msgs::Twist>(
      // In lock step every command counts; otherwise only the last one is worth anything.
      topic, lock_step_ ? 0 : 1, handle, {}, ros::TransportHints().tcpNoDelay()));
}

void SimNode::advance(const ros::SteadyTimerEvent& /*event*/) {
  server_.serve(toTicks(simulation_.time() - start_s_));
  step(pacer_->stepsDue(ros::SteadyTime::now().toSec()));
  diagnostics_.update();
  if (pacer_->speed() < kLowSpeedShare * pacer_->targetSpeed()) {
    ROS_WARN_THROTTLE(10.0, "the machine is too slow: %.2g times real time instead of %.2g",
                      pacer_->speed(), pacer_->targetSpeed());
  }
}

LockStepHost::Moment SimNode::advanceTick() {
  step(static_cast<int>(std::lround(options_.lock_step.period_s / simulation_.stepDuration())));
  return {ros::Time(start_s_) + ros::Duration(simulation_.time() - start_s_), last_frame_};
}

void SimNode::step(int count) {
  std::vector<CapturedFrame> frames;
  for (int due = count; due > 0; --due) {
    std::vector<CapturedFrame> leaving = simulation_.step();
    std::move(leaving.begin(), leaving.end(), std::back_inserter(frames));
  }
  // The clock first: who gets a frame then knows the time at which it came.
  if (simulation_.time() >= next_clock_s_) {
    publishClock(simulation_.time());
  }
  sendFrames(frames);
  publishTruth();
}

void SimNode::sendFrames(const std::vector<CapturedFrame>& frames) {
  for (const CapturedFrame& frame : frames) {
    const std::size_t receivers = server_.send(
        toNatNet(frame, start_s_, options_.natnet.up_axis, options_.natnet.body_height_m));
    last_frame_ = receivers > 0 ? frame.number : last_frame_;
  }
}

void SimNode::publishClock(double time_s) {
  rosgraph_msgs::Clock message;
  message.clock.fromSec(time_s);
  clock_publisher_.publish(message);
  // Before the lab begins the same time is told again and again, which is none of these periods.
  next_clock_s_ = std::clamp(next_clock_s_ + clock_period_s_, time_s, time_s + clock_period_s_);
}

void SimNode::publishTruth() {
  if (simulation_.time() < next_truth_s_) {
    return;
  }
  sylph_msgs::SimulationTruth message;
  message.header.stamp.fromSec(simulation_.time());
  message.header.frame_id = sylph_ros::kMapFrame;
  for (std::size_t robot = 0; robot < experiment_.robots.size(); ++robot) {
    message.robots.push_back(experiment_.robots[robot].name);
    message.poses.push_back(toMessage(simulation_.poses()[robot]));
  }
  message.min_separation_m = simulation_.minSeparation();
  message.collisions = simulation_.collisions();
  message.obstacle_entries = simulation_.obstacleEntries();
  message.active_faults = static_cast<std::uint32_t>(simulation_.activeFaults());
  if (lock_step_) {
    // Whoever listens in lock step waits for as many as were announced.
    lock_step_->countMessage(truth_publisher_.getTopic());
  }
  truth_publisher_.publish(message);
  next_truth_s_ = std::max(next_truth_s_ + 1.0 / options_.truth_rate_hz, simulation_.time());
}

void SimNode::onCommand(std::size_t robot, const geometry_msgs::Twist& message) {
  simulation_.command(robot, {message.linear.x, message.linear.y, message.angular.z});
}

bool SimNode::onInjectFault(sylph_msgs::InjectFault::Request& request,
                            sylph_msgs::InjectFault::Response& response) {
  try {
    simulation_.inject(fromMessage(request, experiment_));
    response.success = 1;
    ROS_INFO("fault: %s", request.kind.c_str());
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

void SimNode::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  if (pacer_ && pacer_->speed() < kLowSpeedShare * pacer_->targetSpeed()) {
    status.summary(DiagnosticStatus::WARN, "slower than asked for");
  } else {
    status.summary(DiagnosticStatus::OK, lock_step_ ? "in lock step" : "on time");
  }
  if (lock_step_ && !lock_step_->silent().empty()) {
    status.summary(DiagnosticStatus::WARN, "goes on without nodes that do not answer");
  }
  status.add("speed asked for", target_speed_);
  status.add("speed", pacer_ ? pacer_->speed() : lock_step_->speed());
  status.add("NatNet clients", server_.clientCount());
  status.add("faults now", simulation_.activeFaults());
  status.add("collisions", simulation_.collisions());
  status.add("smallest separation [m]", simulation_.minSeparation());
}

}  // namespace sylph_sim
