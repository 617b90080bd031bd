#include "sylph_adg_central/central_node.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <filesystem>

#include "sylph_adg_central/result_file.hpp"
#include "sylph_core/adg/explanation.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_core/mapf/plan_file.hpp"
#include "sylph_ros/experiment.hpp"
#include "sylph_ros/parameters.hpp"
#include "sylph_ros/plan_messages.hpp"
#include "sylph_ros/state_messages.hpp"
#include "sylph_ros/task_messages.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_adg_central {
namespace {

using sylph::ExecutionMode;

/// AdgState on change, but not more often than this [s].
constexpr double kShortestStatePeriod = 0.02;
constexpr std::uint32_t kQueue = 1000;
/// The folder that this run has taken. The launch file empties it, so that each run begins anew.
constexpr char kTakenFolderParameter[] = "run_folder_taken";

/// The folder given, or a new one that a restarted node finds again.
std::string runFolderPath(const ros::NodeHandle& nh, const sylph::Experiment& experiment) {
  std::string path;
  sylph_ros::read(nh, sylph_ros::kRunFolderParameter, path);
  if (path.empty()) {
    path = defaultRunFolder(experiment.name, std::time(nullptr));
    nh.setParam(sylph_ros::kRunFolderParameter, path);
  }
  return path;
}

bool isTaken(const ros::NodeHandle& nh, const std::string& folder) {
  std::string taken;
  sylph_ros::read(nh, kTakenFolderParameter, taken);
  return taken == folder;
}

void tell(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    ROS_INFO("%s", line.c_str());
  }
}

}  // namespace

CentralNode::CentralNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : nh_(nh),
      private_nh_(private_nh),
      clock_(sylph_ros::SteadyClock::fromParameter(nh)),
      experiment_(sylph_ros::loadExperiment(nh)),
      margin_(sylph::requireSafetyMargin(experiment_)),
      options_(loadCentralOptions(private_nh, experiment_)),
      frame_(sylph::cellFrameOf(experiment_)),
      names_(namesOf(experiment_)),
      is_restart_(isTaken(nh, runFolderPath(nh, experiment_))),
      folder_(runFolderPath(nh, experiment_), experiment_, is_restart_),
      log_(folder_.eventLog(), names_),
      execution_(names_, experiment_.grid.rows(), experiment_.grid.cols(), experiment_.cell_size_m,
                 options_.limits, experiment_.corner),
      condition_log_(names_),
      diagnostics_(nh, private_nh) {
  ROS_INFO("%s", margin_.summary().c_str());
  ROS_INFO("run folder: %s", folder_.path().c_str());
  rebuild();
  diagnostics_.setHardwareID("none");
  diagnostics_.add("execution", this, &CentralNode::reportDiagnostics);
  state_publisher_ = clock_.advertise<sylph_msgs::AdgState>(nh_, sylph_ros::kAdgStateTopic, 10);
  for (const std::string& name : names_) {
    task_publishers_.push_back(clock_.advertise<sylph_msgs::Task>(
        nh_, sylph_ros::robotTopic(nh_, name, sylph_ros::kTaskTopic), kQueue));
  }
  subscribe();
  advertiseServices();
  timer_ = clock_.createTimer(nh_, options_.heartbeat_period_s, [this] { onTimer(); });
}

CentralNode::~CentralNode() {
  tell(condition_log_.takeAll(clock_.now()));
  if (is_result_due_) {
    try {
      saveResult();
    } catch (const std::exception& error) {
      ROS_ERROR("%s", error.what());
    }
  }
}

void CentralNode::rebuild() {
  for (const sylph::StampedEvent& past : log_.past()) {
    try {
      execution_.replay(past.event);
    } catch (const std::exception& error) {
      throw std::runtime_error(folder_.eventLog() +
                               ": does not fit the experiment: " + error.what());
    }
    record_.add(past);
  }
  if (is_restart_ && !log_.past().empty()) {
    ROS_WARN("rebuilt from %zu events: plan %u, %s", log_.past().size(), execution_.planId(),
             toString(execution_.phase()).c_str());
  }
  const auto phase = execution_.phase();
  is_result_due_ = execution_.plan() != nullptr && phase != sylph::ExecutionPhase::Finished &&
                   phase != sylph::ExecutionPhase::Refused;
  if (!is_restart_ && !log_.past().empty()) {
    if (!is_result_due_) {
      folder_.refuse("that is over");
    }
    // What was written when that launch ended is no result.
    std::filesystem::remove(folder_.result());
    notice_ = "plan " + std::to_string(execution_.planId()) +
              " of an earlier launch is resumed; to drop it, start with another run folder than " +
              folder_.path();
    ROS_WARN("%s", notice_.c_str());
  }
  nh_.setParam(kTakenFolderParameter, folder_.path());
}

template <typename Message>
void CentralNode::subscribe(const std::string& topic, std::uint32_t queue_size,
                            void (CentralNode::*handle)(const Message&)) {
  subscribers_.push_back(clock_.subscribe<Message>(
      nh_, topic, queue_size,
      [this, handle](const Message& message) { (this->*handle)(message); }));
}

void CentralNode::subscribe() {
  subscribe(sylph_ros::kJointActionsTopic, 1, &CentralNode::onJointActions);
  subscribe(sylph_ros::kSeparationTopic, 1, &CentralNode::onSeparation);
  subscribe(sylph_ros::kEmergencyStopTopic, 1, &CentralNode::onEmergencyStop);
  subscribe(sylph_ros::kSimulationTruthTopic, 1, &CentralNode::onTruth);
  subscribe(std::string(sylph_ros::kExecuteMissionAction) + "/result", 10,
            &CentralNode::onMissionResult);
  for (int robot = 0; robot < execution_.robotCount(); ++robot) {
    subscribers_.push_back(clock_.subscribe<sylph_msgs::TaskReport>(
        nh_, sylph_ros::robotTopic(nh_, execution_.name(robot), sylph_ros::kTaskReportTopic), 10,
        [this, robot](const sylph_msgs::TaskReport& message) { onReport(robot, message); }));
  }
}

void CentralNode::advertiseServices() {
  const auto advertise = [this](const char* name, ExecutionMode mode) {
    services_.push_back(
        nh_.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
            name, [this, mode](std_srvs::Trigger::Request& /*request*/,
                               std_srvs::Trigger::Response& response) {
              return setMode(mode, response);
            }));
  };
  advertise(sylph_ros::kPauseService, ExecutionMode::Pause);
  advertise(sylph_ros::kStopService, ExecutionMode::Stop);
  advertise(sylph_ros::kResumeService, ExecutionMode::Run);
  services_.push_back(
      nh_.advertiseService(sylph_ros::kDeclareLostService, &CentralNode::onDeclareLost, this));
}

void CentralNode::onJointActions(const sylph_msgs::JointActions& message) {
  if (message.plan_id == 0) {
    return;  // the planner's mission is over
  }
  if (!broken_.empty()) {
    broken_plan_id_ = message.plan_id;
    publishState();
    return;
  }
  try {
    execution_.submit(sylph_ros::fromMessage(message), clock_.now());
  } catch (const std::invalid_argument& error) {
    execution_.refuse(message.plan_id, error.what());
  }
  flush();
}

void CentralNode::onReport(int robot, const sylph_msgs::TaskReport& message) {
  const std::optional<sylph::RobotReport> report = sylph_ros::fromMessage(message);
  if (!report) {
    ROS_WARN_THROTTLE(1.0, "malformed report of %s", execution_.name(robot).c_str());
    return;
  }
  execution_.report(robot, *report, clock_.now());
  if (is_result_due_) {
    record_.addTrackingError(message.tracking_error_m);
  }
  flush();
}

void CentralNode::onSeparation(const sylph_msgs::SeparationState& message) {
  if (std::isfinite(message.min_separation_m)) {
    record_.setMinSeparation(message.min_separation_m);
  }
  if (message.violated != 0) {
    emergency_reason_ = "separation monitor: " + message.min_robot_a + " and " +
                        message.min_robot_b + " came too close";
  }
}

void CentralNode::onEmergencyStop(const std_msgs::Bool& message) {
  execution_.setEmergencyStop(message.data != 0, emergency_reason_);
  flush();
}

void CentralNode::onTruth(const sylph_msgs::SimulationTruth& message) {
  record_.setCollisions(message.collisions);
}

void CentralNode::onMissionResult(const sylph_msgs::ExecuteMissionActionResult& message) {
  using Result = sylph_msgs::ExecuteMissionResult;
  const Result& told = message.result;
  if (told.outcome == Result::SUCCESS || told.outcome == Result::INCOMPLETE || !broken_.empty()) {
    return;
  }
  sylph::RunResult result;
  if (is_result_due_) {
    result = record_.result(execution_, 0.0);
  }
  result.success = false;
  result.message = told.message;
  result.robots = static_cast<int>(told.robots);
  result.arrived = static_cast<int>(told.arrived);
  result.planning_s = told.planning_s;
  try {
    writeResult(result, folder_.result());
  } catch (const std::exception& error) {
    breakOff(error.what());
  }
}

bool CentralNode::onDeclareLost(sylph_msgs::DeclareLost::Request& request,
                                sylph_msgs::DeclareLost::Response& response) {
  const std::optional<int> robot = execution_.indexOf(request.robot_id);
  response.success = static_cast<std::uint8_t>(robot.has_value());
  if (!robot) {
    response.message = "robot '" + request.robot_id + "' is not in the lab";
    return true;
  }
  execution_.declareLost(*robot, "declared by the operator");
  response.message = request.robot_id + " is lost; " + toString(execution_.phase());
  flush();
  return true;
}

bool CentralNode::setMode(ExecutionMode mode, std_srvs::Trigger::Response& response) {
  const bool is_granted = execution_.setMode(mode, "by the operator");
  response.success = static_cast<std::uint8_t>(is_granted);
  response.message = is_granted ? toString(execution_.mode())
                                : emergency_reason_ + ": reset the separation monitor first";
  flush();
  return true;
}

void CentralNode::onTimer() {
  execution_.tick(clock_.now());
  flush();
  tell(condition_log_.takeSettled(clock_.now()));
  if (clock_.now() - state_sent_s_ >= options_.heartbeat_period_s / 2.0) {
    publishState();
  }
  diagnostics_.update();
}

struct CentralNode::Follow {
  CentralNode& node;

  void operator()(const sylph::event::Started& started) const {
    node.is_result_due_ = true;
    node.notice_.clear();
    sylph::savePlan(started.plan->plan, node.folder_.plan());
    ROS_INFO("plan %u of %zu robots and %u steps is carried out", started.plan->plan_id,
             started.plan->robots.size(), started.plan->steps());
    for (int robot = 0; robot < node.execution_.robotCount(); ++robot) {
      const sylph::RobotMonitor& monitor = node.execution_.monitor(robot);
      node.logCondition(robot, monitor.condition(), monitor.trouble(node.clock_.now()));
    }
  }
  void operator()(const sylph::event::Refused& refused) const {
    ROS_ERROR("refused: %s", refused.reason.c_str());
    node.saveResult();
  }
  void operator()(const sylph::event::Condition& event) const {
    node.logCondition(event.robot, event.condition, event.reason);
  }
  void operator()(const sylph::event::Lost& lost) const {
    ROS_WARN("%s is lost: %s", node.execution_.name(lost.robot).c_str(), lost.reason.c_str());
  }
  void operator()(const sylph::event::Mode& mode) const {
    ROS_WARN("%s: %s", toString(mode.mode).c_str(), mode.reason.c_str());
  }
  void operator()(const sylph::event::Phase& phase) const {
    if (phase.phase == sylph::ExecutionPhase::Finished) {
      tell(node.condition_log_.takeAll(node.clock_.now()));
      node.saveResult();
    }
  }
  template <typename Other>
  void operator()(const Other& /*event*/) const {}
};

void CentralNode::flush() {
  const double stamp_s = clock_.stamp().toSec();
  // First the log, then the robots: a task that was sent and is not in the log would be unknown
  // after a restart, and its cells free for others.
  const std::vector<sylph::ExecutionEvent> events = execution_.takeEvents();
  const std::vector<sylph::TaskOrder> orders = execution_.takeOrders(clock_.now());
  has_changed_ = has_changed_ || !events.empty();
  if (broken_.empty()) {
    try {
      for (const sylph::ExecutionEvent& event : events) {
        log_.append({stamp_s, event});
        record_.add({stamp_s, event});
      }
      for (const sylph::TaskOrder& order : orders) {
        sylph_msgs::Task task = sylph_ros::toMessage(order, execution_.name(order.robot), frame_);
        task.header.stamp = clock_.stamp();
        task_publishers_[static_cast<std::size_t>(order.robot)].publish(task);
      }
      for (const sylph::ExecutionEvent& event : events) {
        std::visit(Follow{*this}, event.what);
      }
    } catch (const std::exception& error) {
      breakOff(error.what());
    }
  }
  if (has_changed_ && clock_.now() - state_sent_s_ >= kShortestStatePeriod) {
    publishState();
  }
}

void CentralNode::logCondition(int robot, sylph::RobotCondition condition,
                               const std::string& reason) {
  // Before a mission robots wait for their first poses, and after it all goes down.
  const bool matters = is_result_due_ && condition != sylph::RobotCondition::Lost;
  const auto line = condition_log_.note(robot, matters ? condition : sylph::RobotCondition::Ok,
                                        reason, clock_.now());
  if (line) {
    ROS_WARN("%s", line->c_str());
  }
}

void CentralNode::breakOff(const std::string& reason) {
  broken_ = reason;
  broken_plan_id_ = execution_.planId();
  has_changed_ = true;
  ROS_ERROR("the mission is broken off, robots finish the tasks that they have: %s",
            reason.c_str());
}

void CentralNode::publishState() {
  has_changed_ = false;
  state_sent_s_ = clock_.now();
  sylph_msgs::AdgState state = sylph_ros::toMessage(explain(execution_, state_sent_s_));
  state.header.stamp = clock_.stamp();
  if (!broken_.empty()) {
    state.plan_id = broken_plan_id_;
    state.phase = sylph_msgs::AdgState::REFUSED;
    state.message = broken_;
  } else if (state.message.empty() && is_result_due_) {
    state.message = notice_;
  }
  state.elapsed_s = record_.elapsed(state.header.stamp.toSec(),
                                    execution_.phase() == sylph::ExecutionPhase::Finished);
  state_publisher_.publish(state);
}

void CentralNode::saveResult() {
  is_result_due_ = false;
  const double cell_s = experiment_.cell_size_m / experiment_.execution.speed_limit_mps;
  const sylph::RunResult result = record_.result(execution_, cell_s);
  writeResult(result, folder_.result());
  ROS_INFO("%s: %s", folder_.result().c_str(), result.message.c_str());
}

void CentralNode::reportDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  status.summary(DiagnosticStatus::OK, toString(execution_.phase()));
  if (!broken_.empty()) {
    status.mergeSummary(DiagnosticStatus::ERROR, broken_);
  }
  if (execution_.phase() == sylph::ExecutionPhase::Refused) {
    status.summary(DiagnosticStatus::ERROR, execution_.message());
  } else if (execution_.mode() != ExecutionMode::Run) {
    status.mergeSummary(DiagnosticStatus::WARN,
                        toString(execution_.mode()) + ": " + execution_.message());
  }
  const double now_s = clock_.now();
  for (int robot = 0; robot < execution_.robotCount(); ++robot) {
    const std::string trouble = execution_.monitor(robot).trouble(now_s);
    if (!trouble.empty()) {
      status.mergeSummary(DiagnosticStatus::WARN, execution_.name(robot) + ": " + trouble);
    }
  }
  status.add("plan_id", execution_.planId());
  status.add("robots", execution_.missionGoals().size());
  status.add("mode", toString(execution_.mode()));
  status.add("run_folder", folder_.path());
  status.add("promised_separation_m", margin_.promisedSeparation());
}

}  // namespace sylph_adg_central
