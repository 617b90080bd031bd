#include "sylph_sim/sim_node.hpp"

#include <rosgraph_msgs/Clock.h>
#include <sylph_msgs/SimulationTruth.h>

#include <algorithm>
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
/// Below this share of the speed asked for the node says so.
constexpr double kLowSpeedShare = 0.9;

sylph_natnet::ServerOptions serverOptions(const Options& options) {
  sylph_natnet::ServerOptions server;
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

}  // namespace

SimNode::SimNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
    : options_(sylph_ros::readStrictly(private_nh, readOptions)),
      experiment_(sylph_ros::loadExperiment(nh)),
      clock_(sylph_ros::SteadyClock::fromParameter(nh)),
      start_s_(ros::WallTime::now().toSec()),
      simulation_(options_.simulation, experiment_, start_s_),
      pacer_(simulation_.stepDuration(), clock_.speed(), kMaxBacklog_s),
      server_(serverOptions(options_)),
      clock_period_s_(
          std::max(options_.clock_period_s, clock_.speed() / options_.clock_wall_rate_limit_hz)),
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
  for (std::size_t robot = 0; robot < experiment_.robots.size(); ++robot) {
    const std::string topic =
        sylph_ros::robotTopic(nh, experiment_.robots[robot].name, sylph_ros::kCommandTopic);
    command_subscribers_.push_back(nh.subscribe<geometry_msgs::Twist>(
        topic, 1,
        [this, robot](const geometry_msgs::TwistConstPtr& message) { onCommand(robot, *message); },
        {}, ros::TransportHints().tcpNoDelay()));
  }
  inject_fault_server_ =
      nh.advertiseService(sylph_ros::kInjectFaultService, &SimNode::onInjectFault, this);
  diagnostics_.setHardwareID("none");
  diagnostics_.add("simulation", this, &SimNode::diagnose);
  const ros::WallDuration period =
      std::max(clock_.wall(simulation_.stepDuration()), ros::WallDuration(kMinTimerPeriodWall));
  timer_ = nh.createSteadyTimer(period, &SimNode::advance, this);
  ROS_INFO("simulating %zu robots at %.3g times real time, NatNet %s on port %u",
           experiment_.robots.size(), clock_.speed(),
           sylph_natnet::toString(options_.natnet.version).c_str(), server_.commandPort());
}

void SimNode::advance(const ros::SteadyTimerEvent& /*event*/) {
  server_.serve(toTicks(simulation_.time() - start_s_));
  std::vector<CapturedFrame> frames;
  for (int due = pacer_.stepsDue(ros::SteadyTime::now().toSec()); due > 0; --due) {
    std::vector<CapturedFrame> leaving = simulation_.step();
    std::move(leaving.begin(), leaving.end(), std::back_inserter(frames));
  }
  // The clock first: who gets a frame then knows the time at which it came.
  publishClock();
  sendFrames(frames);
  publishTruth();
  diagnostics_.update();
  if (pacer_.speed() < kLowSpeedShare * pacer_.targetSpeed()) {
    ROS_WARN_THROTTLE(10.0, "the machine is too slow: %.2g times real time instead of %.2g",
                      pacer_.speed(), pacer_.targetSpeed());
  }
}

void SimNode::sendFrames(const std::vector<CapturedFrame>& frames) {
  for (const CapturedFrame& frame : frames) {
    server_.send(toNatNet(frame, start_s_, options_.natnet.up_axis, options_.natnet.body_height_m));
  }
}

void SimNode::publishClock() {
  if (simulation_.time() < next_clock_s_) {
    return;
  }
  rosgraph_msgs::Clock message;
  message.clock.fromSec(simulation_.time());
  clock_publisher_.publish(message);
  next_clock_s_ = std::max(next_clock_s_ + clock_period_s_, simulation_.time());
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
  if (pacer_.speed() < kLowSpeedShare * pacer_.targetSpeed()) {
    status.summary(DiagnosticStatus::WARN, "slower than asked for");
  } else {
    status.summary(DiagnosticStatus::OK, "on time");
  }
  status.add("speed asked for", pacer_.targetSpeed());
  status.add("speed", pacer_.speed());
  status.add("NatNet clients", server_.clientCount());
  status.add("faults now", simulation_.activeFaults());
  status.add("collisions", simulation_.collisions());
  status.add("smallest separation [m]", simulation_.minSeparation());
}

}  // namespace sylph_sim
