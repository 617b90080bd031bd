#include "sylph_mocap_bridge/mocap_bridge_node.hpp"

#include <ros/console.h>

#include <algorithm>

#include "sylph_mocap_bridge/natnet_input.hpp"
#include "sylph_mocap_bridge/pose_topics_input.hpp"
#include "sylph_ros/experiment.hpp"

namespace sylph_mocap_bridge {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kDiagnosticsPeriodS = 1.0;

unsigned char levelOf(Severity severity) {
  switch (severity) {
    case Severity::Ok:
      return DiagnosticStatus::OK;
    case Severity::Warning:
      return DiagnosticStatus::WARN;
    case Severity::Error:
      break;
  }
  return DiagnosticStatus::ERROR;
}

}  // namespace

MocapBridgeNode::MocapBridgeNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : nh_(nh),
      experiment_(sylph_ros::loadExperiment(nh_)),
      options_(loadOptions(private_nh, experiment_)),
      clock_(sylph_ros::SteadyClock::fromParameter(nh_, sylph_ros::LockStep::Stage::First)),
      tracks_(options_.tracks),
      publishers_(nh_, clock_, namesOf(experiment_), options_.rates, options_.tracks.tracker),
      seen_counts_(experiment_.robots.size()),
      input_(makeInput()),
      updater_(nh_, private_nh) {
  updater_.setHardwareID("motion capture");
  updater_.add("link", this, &MocapBridgeNode::reportLink);
  updater_.add("bodies", this, &MocapBridgeNode::reportBodies);
  diagnostics_timer_ = clock_.createTimer(nh_, kDiagnosticsPeriodS * clock_.speed(),
                                          [this] { updater_.force_update(); });
}

std::unique_ptr<MeasurementInput> MocapBridgeNode::makeInput() {
  if (options_.input == Input::PoseTopics) {
    return std::make_unique<PoseTopicsInput>(nh_, options_.pose_topic, options_.stamp,
                                             experiment_.robots, *this);
  }
  std::vector<std::string> rigid_bodies;
  for (const sylph::RobotSpec& robot : experiment_.robots) {
    rigid_bodies.push_back(robot.rigid_body);
  }
  return std::make_unique<NatnetInput>(options_.client, options_.stamp, rigid_bodies,
                                       ros::Time::isSimTime(), clock_, *this);
}

void MocapBridgeNode::onMeasurements(const std::vector<Measurement>& measurements, double now_s) {
  std::vector<ReliablePose> poses;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Measurement& measurement : measurements) {
      if (const auto pose = tracks_.update(measurement, now_s)) {
        poses.push_back(*pose);
      }
    }
  }
  publishers_.publish(poses);
}

void MocapBridgeNode::onRestart() {
  const std::lock_guard<std::mutex> lock(mutex_);
  tracks_.reset();
}

void MocapBridgeNode::reportLink(diagnostic_updater::DiagnosticStatusWrapper& report) {
  const Finding finding = input_->look(report);
  report.summary(levelOf(finding.severity), finding.text);
  // The error stream: roslaunch shows it on the screen, whatever the node's output is set to.
  if (announcer_.isDue(finding, ros::SteadyTime::now().toSec())) {
    if (finding.severity == Severity::Ok) {
      ROS_INFO("motion capture: %s", finding.text.c_str());
    } else {
      ROS_WARN("motion capture: %s", finding.text.c_str());
    }
  }
}

void MocapBridgeNode::reportBodies(diagnostic_updater::DiagnosticStatusWrapper& report) {
  std::vector<TrackCounts> counts;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    counts = tracks_.counts();
  }
  report.summary(DiagnosticStatus::OK, "all bodies are seen");
  for (std::size_t robot = 0; robot < counts.size(); ++robot) {
    const std::string& name = experiment_.robots[robot].name;
    const double ratio = goodRatio(counts[robot], seen_counts_[robot]);
    const std::string problem = bodyProblem(counts[robot], seen_counts_[robot]);
    report.add(name + " valid ratio", ratio);
    report.add(name + " pose age [s]", counts[robot].last_age_s);
    if (!problem.empty()) {
      report.mergeSummary(ratio > 0.0 ? DiagnosticStatus::WARN : DiagnosticStatus::ERROR,
                          name + " " + problem);
    }
  }
  seen_counts_ = counts;
}

}  // namespace sylph_mocap_bridge
