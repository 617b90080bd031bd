#include "sylph_planner_node/mission_client.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <ros/names.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "sylph_core/text/join.hpp"
#include "sylph_planner_node/mission_text.hpp"
#include "sylph_planner_node/planner_watch.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/parameters.hpp"
#include "sylph_ros/reachability.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

constexpr std::chrono::milliseconds kPollPeriod{50};
constexpr char kReportFile[] = "result.yaml";
constexpr std::chrono::seconds kReachabilityPeriod{10};
constexpr double kConnectTimeout = 1.0;  // [s]

void say(const std::string& text) {
  std::cout << text << std::endl;
}

/// Robots of which no pose has come yet. Callbacks are served by another thread.
class AwaitedPoses {
 public:
  struct Robot {
    std::string topic;
    std::string body;
  };

  AwaitedPoses(const ros::NodeHandle& nh, const std::vector<sylph::RobotSpec>& robots) {
    for (const sylph::RobotSpec& robot : robots) {
      const std::string topic = sylph_ros::robotTopic(nh, robot.name, sylph_ros::kPoseTopic);
      const boost::function<void(const geometry_msgs::PoseStampedConstPtr&)> note =
          [waiting = waiting_, topic](const geometry_msgs::PoseStampedConstPtr&) {
            const std::lock_guard<std::mutex> lock(waiting->mutex);
            std::vector<Robot>& missing = waiting->robots;
            missing.erase(std::remove_if(missing.begin(), missing.end(),
                                         [&](const Robot& other) { return other.topic == topic; }),
                          missing.end());
          };
      const std::lock_guard<std::mutex> lock(waiting_->mutex);
      waiting_->robots.push_back({topic, robot.rigid_body});
      subscribers_.push_back(
          ros::NodeHandle(nh).subscribe<geometry_msgs::PoseStamped>(topic, 1, note));
    }
  }

  /// In the order of the experiment.
  std::vector<Robot> missing() const {
    const std::lock_guard<std::mutex> lock(waiting_->mutex);
    return waiting_->robots;
  }

 private:
  struct Waiting {
    std::mutex mutex;
    std::vector<Robot> robots;
  };
  /// A callback may outlive this.
  std::shared_ptr<Waiting> waiting_ = std::make_shared<Waiting>();
  std::vector<ros::Subscriber> subscribers_;
};

std::string topicsOf(const std::vector<AwaitedPoses::Robot>& robots) {
  return sylph::join(robots, ", ", [](const auto& robot) { return robot.topic; });
}

std::string bodiesOf(const std::vector<AwaitedPoses::Robot>& robots) {
  return sylph::join(robots, ", ", [](const auto& robot) { return robot.body; });
}

/// Empty if the run has no folder.
std::filesystem::path reportPath(const ros::NodeHandle& nh) {
  std::string folder;
  nh.getParam(sylph_ros::kRunFolderParameter, folder);
  return folder.empty() ? std::filesystem::path() : std::filesystem::path(folder) / kReportFile;
}

std::optional<std::filesystem::file_time_type> timeOf(const std::filesystem::path& path) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(path, error);
  return error ? std::nullopt : std::make_optional(time);
}

std::string headlineOf(const sylph::Experiment& experiment) {
  return "experiment " + experiment.name + ": " + std::to_string(experiment.robots.size()) +
         " robots, seed " + std::to_string(experiment.seed) + ", planner " +
         experiment.planning.planner;
}

std::chrono::steady_clock::duration seconds(double value) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(value));
}

}  // namespace

ClientOptions readClientOptions(sylph_ros::ParameterReader& reader) {
  ClientOptions options;
  const sylph::Range positive = sylph::Range::positive();
  reader.read("exit_when_done", options.exit_when_done,
              "false: keeps running after the result, so that what was launched beside it stays");
  reader.read("start_timeout_s", options.start_timeout_s, positive,
              "wall time that it waits for the planner, also for one that hangs, and for each "
              "robot's pose");
  reader.read("progress_period_s", options.progress_period_s, positive,
              "wall time between two progress lines when nothing changes");
  reader.read("report_wait_s", options.report_wait_s, positive,
              "wall time that it waits for `result.yaml`");
  return options;
}

MissionClient::MissionClient(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : MissionClient(nh, sylph_ros::readStrictly(private_nh, readClientOptions),
                    sylph_ros::loadExperiment(nh), {}, "") {
  mission_ = sylph_ros::toGoal(experiment_);
  headline_ = headlineOf(experiment_);
  joinLockStep();
}

MissionClient::MissionClient(const ros::NodeHandle& nh, const ClientOptions& options,
                             sylph::Experiment lab, sylph_msgs::ExecuteMissionGoal mission,
                             std::string headline)
    : nh_(nh),
      options_(options),
      experiment_(std::move(lab)),
      mission_(std::move(mission)),
      headline_(std::move(headline)),
      client_(nh_, sylph_ros::kExecuteMissionAction, false),
      capture_findings_(nh_.getNamespace()),
      diagnostics_subscriber_(
          nh_.subscribe("/diagnostics", 10, &MissionClient::onDiagnostics, this)) {
  // The planner refuses such weights too, but nobody would hear of it before the time-out.
  sylph::loadPolicyFor(experiment_.planning.planner, experiment_.planning.weights_path);
}

bool MissionClient::run() {
  const Clock::time_point deadline = Clock::now() + seconds(options_.start_timeout_s);
  say(headline_);
  waitForServer(deadline);
  if (!lock_step_) {
    waitForPoses(deadline);  // in lock step none come before the mission is there
  }
  old_result_ = timeOf(reportPath(nh_));
  sendMission();
  waitForResult();
  if (!ros::ok()) {
    return false;
  }
  const auto result = client_.getResult();
  if (!result) {
    say("the mission ended without a result: " + client_.getState().toString());
    return false;
  }
  say(resultText(*result));
  printRunReport();
  return result->outcome == sylph_msgs::ExecuteMissionResult::SUCCESS &&
         client_.getState() == actionlib::SimpleClientGoalState::SUCCEEDED;
}

void MissionClient::joinLockStep() {
  const auto clock =
      sylph_ros::SteadyClock::fromParameter(nh_, sylph_ros::LockStep::Stage::StartOnly);
  lock_step_ = clock.lockStep();
  if (lock_step_) {
    lock_step_->requireAtStart([this] { return is_accepted_.load(); });
  }
}

void MissionClient::waitForServer(Clock::time_point deadline) {
  Clock::time_point next_reminder = Clock::now() + seconds(options_.progress_period_s);
  while (ros::ok() && !client_.isServerConnected()) {
    if (Clock::now() > next_reminder) {
      say("waiting for the planner: nobody serves the action " +
          nh_.resolveName(sylph_ros::kExecuteMissionAction) + " yet");
      next_reminder += seconds(options_.progress_period_s);
    }
    if (Clock::now() > deadline) {
      throw std::runtime_error("no planner: nobody serves the action " +
                               nh_.resolveName(sylph_ros::kExecuteMissionAction));
    }
    std::this_thread::sleep_for(kPollPeriod);
  }
}

void MissionClient::waitForPoses(Clock::time_point deadline) {
  const AwaitedPoses poses(nh_, experiment_.robots);
  Clock::time_point next_reminder = Clock::now() + seconds(options_.progress_period_s);
  for (auto missing = poses.missing(); ros::ok() && !missing.empty(); missing = poses.missing()) {
    if (Clock::now() > deadline) {
      // The planner refuses the mission, and the run folder gets a result that says why.
      say("no pose on " + topicsOf(missing) + (missing.size() == 1 ? ": is " : ": are ") +
          bodiesOf(missing) + " seen by the motion capture?");
      sayFindings();
      return;
    }
    if (Clock::now() > next_reminder) {
      say("waiting for a pose on " + topicsOf(missing));
      sayFindings();
      next_reminder += seconds(options_.progress_period_s);
    }
    std::this_thread::sleep_for(kPollPeriod);
  }
}

void MissionClient::onDiagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics) {
  const std::lock_guard<std::mutex> lock(mutex_);
  capture_findings_.note(diagnostics);
}

void MissionClient::sayFindings() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::string& line : networkFindings()) {
    say("    " + line);
  }
  for (const std::string& line : capture_findings_.lines()) {
    say("    " + line);
  }
}

const std::vector<std::string>& MissionClient::networkFindings() {
  if (reachability_.valid()) {
    if (reachability_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      network_findings_ = reachability_.get();
    }
  } else if (Clock::now() - reachability_asked_ > kReachabilityPeriod) {
    reachability_asked_ = Clock::now();
    reachability_ = std::async(
        std::launch::async,
        [fleet = ros::names::parentNamespace(nh_.getNamespace()), robots = namesOf(experiment_)] {
          std::vector<std::string> lines = sylph_ros::robotsElsewhere(fleet, robots);
          const auto unreachable = sylph_ros::unreachablePublishers(fleet, kConnectTimeout);
          lines.insert(lines.end(), unreachable.begin(), unreachable.end());
          return lines;
        });
  }
  return network_findings_;
}

void MissionClient::sendMission() {
  printed_at_ = Clock::now();
  client_.sendGoal(
      mission_, Client::SimpleDoneCallback(), [this] { is_accepted_ = true; },
      [this](const sylph_msgs::ExecuteMissionFeedbackConstPtr& feedback) { onFeedback(feedback); });
}

void MissionClient::waitForResult() {
  const PlannerWatch planner(nh_, sylph_ros::kExecuteMissionAction, options_.start_timeout_s,
                             "; the robots finish the plan that they have");
  while (ros::ok()) {
    planner.requireAlive(client_.isServerConnected());
    const auto state = client_.getState();
    if (state == actionlib::SimpleClientGoalState::LOST) {
      if (!client_.isServerConnected()) {
        std::this_thread::sleep_for(kPollPeriod);
        continue;  // a goal sent now would reach nobody, and the client would wait for ever
      }
      say("the planner was started again: giving it the mission anew");
      sendMission();
    } else if (state.isDone()) {
      return;
    }
    std::this_thread::sleep_for(kPollPeriod);
  }
}

void MissionClient::onFeedback(const sylph_msgs::ExecuteMissionFeedbackConstPtr& feedback) {
  const std::string text = progressText(*feedback, mission_.robots.size());
  const std::string headline = text.substr(0, text.find(':'));
  if (headline == last_headline_ &&
      Clock::now() - printed_at_ < seconds(options_.progress_period_s)) {
    return;
  }
  last_headline_ = headline;
  printed_at_ = Clock::now();
  say(text);
  if (!feedback->waiting.empty()) {
    sayFindings();
  }
}

void MissionClient::printRunReport() {
  const std::filesystem::path path = reportPath(nh_);
  if (path.empty()) {
    say("no run folder: parameter " + nh_.resolveName(sylph_ros::kRunFolderParameter) +
        " is not set");
    return;
  }
  const Clock::time_point deadline = Clock::now() + seconds(options_.report_wait_s);
  while (ros::ok() && timeOf(path) == old_result_ && Clock::now() < deadline) {
    std::this_thread::sleep_for(kPollPeriod);
  }
  std::ifstream file(path);
  if (!file || timeOf(path) == old_result_) {
    say(path.string() + " has not been written");
    return;
  }
  say(path.string() + ":");
  for (std::string line; std::getline(file, line);) {
    say("  " + line);
  }
}

}  // namespace sylph_planner_node
