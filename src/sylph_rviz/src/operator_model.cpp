#include "sylph_rviz/operator_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "sylph_core/geometry/segment.hpp"
#include "sylph_core/text/join.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_rviz/conversions.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

constexpr char kReplay[] = "a replay: no robot hears commands";
constexpr char kNoCentral[] = "no central node is heard";
constexpr char kNoPlanner[] = "no planner takes missions";
constexpr char kUnderWay[] = "a mission is under way: cancel it first";

/// Ten messages of the central node, and four of the planner's feedback, come in this time.
constexpr double kHeardS = 2.0;
/// Before so many timesteps there is no pace to go by.
constexpr std::uint32_t kPaceSteps = 3;
/// Cells ahead that a robot may be in before the central node knows.
constexpr std::size_t kCellsAhead = 3;

std::string phaseText(const AdgState& state) {
  switch (state.phase) {
    case AdgState::PENDING:
      return "waits to begin";
    case AdgState::EXECUTING:
      return "executing";
    case AdgState::CUTTING:
      return "runs to the commit cut";
    case AdgState::AT_CUT:
      return "plans anew";
    case AdgState::FINISHED:
      return "finished";
    case AdgState::REFUSED:
      return "plan refused";
    default:
      return "no mission";
  }
}

std::string stateText(RobotStatus status, const RobotExecution& robot) {
  switch (status) {
    case RobotStatus::Enqueued:
      return "drives";
    case RobotStatus::Staged:
      return "waits";
    case RobotStatus::Done:
      return "arrived";
    case RobotStatus::Held:
      return "held";
    case RobotStatus::Fault:
      return conditionName(robot);
    default:
      return "idle";
  }
}

std::string cellText(const sylph_msgs::Cell& cell) {
  return sylph::toString(sylph_ros::fromMessage(cell));
}

sylph::Cell cellUnder(const MapExtent& map, const sylph::Pose2d& pose) {
  return sylph::CellFrame(map.rows, map.cell_size_m, map.corner).toCell(sylph::position(pose));
}

/// Empty while there is no map to put the pose on.
std::string whereText(const Scene& scene, const RobotView& robot) {
  if (const auto cell = cellOf(*robot.execution)) {
    return sylph::toString(*cell);
  }
  if (!robot.pose) {
    return "no pose";
  }
  return scene.map ? sylph::toString(cellUnder(*scene.map, *robot.pose)) : "";
}

std::string ownWaitText(const RobotExecution& robot) {
  return "waits " + durationText(robot.waited_s) + " for " + robot.waits_for_robot + " to leave " +
         cellText(robot.waits_for_cell);
}

/// Nothing for a robot that has no SVO in this plan.
std::optional<SvoSeries> svoOf(const sylph::MissionPlan& plan, const std::string& robot) {
  const auto found = std::find(plan.robots.begin(), plan.robots.end(), robot);
  if (found == plan.robots.end()) {
    return std::nullopt;
  }
  const auto agent = static_cast<std::size_t>(found - plan.robots.begin());
  SvoSeries series{robot, {}};
  bool has_any = false;
  for (const sylph::SocialState& social : plan.social) {
    series.svo_deg.push_back(social.svo_deg.at(agent));
    has_any = has_any || std::isfinite(series.svo_deg.back());
  }
  return has_any ? std::make_optional(std::move(series)) : std::nullopt;
}

/// What the robot furthest behind still has to do, at the pace that it has had.
std::optional<double> timeLeft(const AdgState& state) {
  std::uint32_t step = state.steps;
  for (const RobotExecution& robot : state.robots) {
    if (robot.tasks_done < robot.tasks_total && robot.condition != RobotExecution::LOST) {
      step = std::min(step, robot.step);
    }
  }
  if (state.phase != AdgState::EXECUTING || step < kPaceSteps) {
    return std::nullopt;
  }
  return state.elapsed_s * static_cast<double>(state.steps - step) / static_cast<double>(step);
}

}  // namespace

void OperatorModel::setSource(Source source, bool has_planner) {
  source_ = source;
  has_planner_ = has_planner;
}

void OperatorModel::onState(const AdgState& state, double steady_s) {
  if (isBusy(state) && scene_.state && scene_.state->plan_id != state.plan_id) {
    result_.reset();
  }
  setState(scene_, state);
  state_heard_s_ = steady_s;
}

void OperatorModel::onPose(const std::string& robot, const sylph::Pose2d& pose, double stamp_s) {
  for (RobotView& view : scene_.robots) {
    if (view.name == robot) {
      view.pose = pose;
      pose_stamps_s_[robot] = stamp_s;
    }
  }
}

void OperatorModel::onMap(const nav_msgs::OccupancyGrid& map) {
  if (const auto extent = extentOf(map)) {
    scene_.map = extent;
  }
}

void OperatorModel::onFeedback(const sylph_msgs::ExecuteMissionFeedback& feedback,
                               double steady_s) {
  feedback_ = feedback;
  feedback_heard_s_ = steady_s;
  result_.reset();
}

void OperatorModel::onResult(const sylph_msgs::ExecuteMissionResult& result) {
  result_ = result;
  feedback_.reset();
}

bool OperatorModel::hasState(double steady_s) const {
  // A replay that is paused or at its end says nothing and is there all the same.
  return scene_.state && (source_ == Source::Replay || steady_s - *state_heard_s_ < kHeardS);
}

bool OperatorModel::isPlanning(double steady_s) const {
  return feedback_ && steady_s - feedback_heard_s_ < kHeardS;
}

bool OperatorModel::isUnderWay(double steady_s) const {
  return isPlanning(steady_s) || (hasState(steady_s) && isBusy(*scene_.state));
}

std::string OperatorModel::headline(double steady_s) const {
  if (!hasState(steady_s)) {
    return source_ == Source::Replay ? "replay: no state yet" : "no central node";
  }
  const AdgState& state = *scene_.state;
  std::string text = isPlanning(steady_s) ? feedback_->phase : phaseText(state);
  if (state.mode != AdgState::RUN) {
    text = std::string(state.mode == AdgState::PAUSE ? "paused" : "STOPPED") + " (" + text + ")";
  }
  const auto arrived = std::count_if(state.robots.begin(), state.robots.end(),
                                     [&state](const RobotExecution& robot) {
                                       return statusOf(state, robot) == RobotStatus::Done;
                                     });
  if (isBusy(state)) {
    text += ", " + std::to_string(arrived) + " of " + std::to_string(state.robots.size()) +
            " robots arrived";
  }
  return (source_ == Source::Replay ? "replay: " : "") + text;
}

void OperatorModel::addMessage(OperatorView& view, double steady_s) const {
  if (hasState(steady_s) && !scene_.state->message.empty()) {
    view.message = scene_.state->message;
    view.is_alarm = true;
  } else if (hasState(steady_s) && isPlanning(steady_s) && !isBusy(*scene_.state) &&
             !feedback_->waiting.empty()) {
    // What the planner waits for before there is a plan.
    view.message = sylph::join(feedback_->waiting, "; ");
  } else if (result_) {
    view.message = sylph_ros::outcomeName(result_->outcome) + ": " + result_->message;
    view.is_alarm = result_->outcome != sylph_msgs::ExecuteMissionResult::SUCCESS;
  }
  addCaptureFindings(view, steady_s);
}

/// Without poses there is no plan: the mission has not even been sent while they are waited for.
void OperatorModel::addCaptureFindings(OperatorView& view, double steady_s) const {
  const bool has_plan = hasState(steady_s) && isBusy(*scene_.state);
  if (capture_findings_.empty() || has_plan || source_ == Source::Replay) {
    return;
  }
  view.is_alarm = view.is_alarm || view.message.empty();
  view.message += (view.message.empty() ? "" : "; ") + sylph::join(capture_findings_, "; ");
}

void OperatorModel::addCommands(OperatorView& view, double steady_s) const {
  if (source_ == Source::Replay) {
    view.start = view.pause = view.resume = view.stop = view.cancel = view.confirm_pose = kReplay;
    return;
  }
  if (!hasState(steady_s)) {
    view.start = view.pause = view.resume = view.cancel = view.confirm_pose = kNoCentral;
    return;  // stop stays: a central node that is not heard may still hear
  }
  const std::uint8_t mode = scene_.state->mode;
  view.start = !has_planner_            ? kNoPlanner
               : isUnderWay(steady_s)   ? kUnderWay
               : mode == AdgState::STOP ? "stopped: resume first"
                                        : "";
  view.pause = mode == AdgState::PAUSE ? "paused already" : mode == AdgState::STOP ? "stopped" : "";
  view.resume = mode == AdgState::RUN ? "robots are free to go" : "";
  view.stop = mode == AdgState::STOP ? "stopped already" : "";
  view.confirm_pose = mode != AdgState::STOP ? "stop first, and look at the robot" : "";
  view.cancel = !isUnderWay(steady_s) ? "no mission is under way" : "";
}

Refusal OperatorModel::goalRefusal(double steady_s) const {
  if (source_ == Source::Replay) {
    return kReplay;
  }
  return !hasState(steady_s)    ? kNoCentral
         : isUnderWay(steady_s) ? kUnderWay
         : !desk_.draft()       ? desk_.plan()
                                : "";
}

void OperatorModel::addGoals(OperatorView& view, double steady_s) const {
  view.goals = desk_.text();
  view.set_goal = goalRefusal(steady_s);
  view.plan = view.go = view.clear_goals = view.save = view.set_goal;
  if (!view.set_goal.empty()) {
    return;
  }
  const bool has_goals = !desk_.draft()->goals().empty();
  view.clear_goals = view.save = has_goals ? "" : "no goal is set";
  view.plan = !has_planner_ ? kNoPlanner : desk_.plan();
  view.go = !view.start.empty() ? view.start : desk_.go();
}

void OperatorModel::addSvo(OperatorView& view) const {
  const RobotView* robot = findRobot(scene_, scene_.selected);
  if (robot == nullptr || !robot->execution || !scene_.state || !scene_.plan ||
      scene_.plan->plan_id != scene_.state->plan_id) {
    return;
  }
  view.svo_step = robot->execution->step;
  auto own = svoOf(*scene_.plan, robot->name);
  if (!own) {
    return;
  }
  view.svo.push_back(std::move(*own));
  const std::string& partner = robot->execution->partner;
  if (auto series = svoOf(*scene_.plan, partner); series && partner != robot->name) {
    view.svo.push_back(std::move(*series));
  }
}

sylph::RobotPoses OperatorModel::poses() const {
  sylph::RobotPoses poses;
  for (const RobotView& robot : scene_.robots) {
    if (robot.pose) {
      poses[robot.name] = {*robot.pose, {}};
    }
  }
  return poses;
}

std::optional<sylph::Point> OperatorModel::handleOf(const RobotView& robot) const {
  const auto goal = desk_.draft()->goals().find(robot.name);
  if (goal != desk_.draft()->goals().end()) {
    return centerOf(scene_, goal->second);
  }
  return centerOf(scene_, cellUnder(*scene_.map, *robot.pose));
}

std::vector<GoalHandle> OperatorModel::handles(double steady_s) const {
  std::vector<GoalHandle> handles;
  // A footprint is not known here; where a cell is large, so are robots.
  constexpr double kClickedPart = 0.7;
  const double cell_size_m = scene_.map ? scene_.map->cell_size_m : 0.0;
  const bool can_set = scene_.map && goalRefusal(steady_s).empty();
  for (std::size_t i = 0; i < scene_.robots.size(); ++i) {
    const RobotView& robot = scene_.robots[i];
    if (robot.pose) {
      handles.push_back({robot.name, std::max(robot.length_m, kClickedPart * cell_size_m),
                         std::max(robot.width_m, kClickedPart * cell_size_m), robotColor(i),
                         can_set ? handleOf(robot) : std::nullopt,
                         can_set && desk_.draft()->goals().count(robot.name) == 0});
    }
  }
  return handles;
}

RobotRow OperatorModel::rowOf(const RobotView& robot, double ros_s) const {
  RobotRow row;
  row.name = robot.name;
  const auto stamp = pose_stamps_s_.find(robot.name);
  if (stamp != pose_stamps_s_.end()) {
    row.pose_age_s = std::max(0.0, ros_s - stamp->second);
  }
  if (!robot.execution || !scene_.state) {
    return row;
  }
  row.status = statusOf(*scene_.state, *robot.execution);
  row.state = stateText(row.status, *robot.execution);
  row.cell = whereText(scene_, robot);
  if (!robot.execution->waits_for_robot.empty()) {
    row.waits = robot.execution->waits_for_robot + ", " + durationText(robot.execution->waited_s);
  }
  row.reason = waitText(*robot.execution);
  row.chain = chainText(scene_, robot.name);
  row.partner = robot.execution->partner;
  if (std::isfinite(robot.execution->svo_deg) && scene_.state->plan_id != 0) {
    row.svo_deg = static_cast<double>(robot.execution->svo_deg);
  }
  row.tracking_error_m = trackingError(scene_, robot);
  return row;
}

OperatorView OperatorModel::view(double ros_s, double steady_s) const {
  OperatorView view;
  view.headline = headline(steady_s);
  view.selected = scene_.selected;
  addMessage(view, steady_s);
  addCommands(view, steady_s);
  addGoals(view, steady_s);
  addSvo(view);
  if (source_ == Source::Replay && replay_extent_) {
    const double length_s = replay_extent_->length.toSec();
    view.replay = {std::clamp(ros_s - replay_extent_->begin.toSec(), 0.0, length_s), length_s};
  }
  for (const RobotView& robot : scene_.robots) {
    view.rows.push_back(rowOf(robot, ros_s));
    if (robot.execution) {
      view.tasks_done += static_cast<int>(robot.execution->tasks_done);
      view.tasks_total += static_cast<int>(robot.execution->tasks_total);
    }
  }
  if (scene_.state && scene_.state->plan_id != 0) {
    view.elapsed_s = scene_.state->elapsed_s;
    view.left_s = timeLeft(*scene_.state);
  }
  return view;
}

std::string durationText(double seconds) {
  char text[32];
  if (seconds < 60.0) {
    std::snprintf(text, sizeof(text), "%.1f s", seconds);
  } else {
    const long whole = std::lround(seconds);
    std::snprintf(text, sizeof(text), "%ld min %02ld s", whole / 60, whole % 60);
  }
  return text;
}

std::string waitText(const RobotExecution& robot) {
  if (robot.condition != RobotExecution::OK) {
    return robot.root_cause;
  }
  if (robot.waits_for_robot.empty()) {
    return "";
  }
  std::string text = ownWaitText(robot);
  if (!robot.root_cause_robot.empty() &&
      (robot.root_cause_robot != robot.waits_for_robot || !robot.root_cause.empty())) {
    text += "; cause: " + robot.root_cause_robot;
    if (!robot.root_cause.empty()) {
      text += ", " + robot.root_cause;
    }
  }
  return text;
}

std::vector<std::string> chainText(const Scene& scene, const std::string& robot) {
  std::vector<std::string> lines;
  for (const RobotView* link : waitChain(scene, robot)) {
    if (!link->execution) {
      continue;
    }
    const RobotExecution& execution = *link->execution;
    if (execution.condition != RobotExecution::OK) {
      lines.push_back(link->name + " " + execution.root_cause);
    } else if (execution.waiting != 0) {
      lines.push_back(link->name + " " + ownWaitText(execution));
    } else if (!lines.empty()) {
      lines.push_back(link->name + " " + stateText(statusOf(*scene.state, execution), execution));
    }
  }
  return lines;
}

std::optional<double> trackingError(const Scene& scene, const RobotView& robot) {
  const auto cell = robot.execution ? cellOf(*robot.execution) : std::nullopt;
  if (!robot.pose || !cell || !scene.map) {
    return std::nullopt;
  }
  const RobotExecution& execution = *robot.execution;
  const sylph::Point position = sylph::position(*robot.pose);
  auto from = centerOf(scene, *cell);
  double nearest_m = sylph::distanceToSegment(position, *from, *from);
  // Only so far ahead: a path that comes back here later would hide how far off the robot is.
  const std::size_t cells = std::min(execution.remaining_path.size(), kCellsAhead + 1);
  for (std::size_t k = 0; k < cells; ++k) {
    const auto to = centerOf(scene, sylph_ros::fromMessage(execution.remaining_path[k]));
    nearest_m = std::min(nearest_m, sylph::distanceToSegment(position, *from, *to));
    from = to;
  }
  return nearest_m;
}

}  // namespace sylph_rviz
