// How a plan starts: what it has to fulfil, and what it is waited for.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <set>

#include "sylph_core/adg/execution.hpp"
#include "sylph_core/mapf/check_plan.hpp"

namespace sylph {
namespace {

using Kind = ExecutionEvent::Kind;

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f m", value);
  return text;
}

/// A cell outside every map, for a robot that takes no part and stands where it stands.
Cell nowhere(int robot) {
  return {-1 - robot, -1};
}

}  // namespace

void Execution::submit(MissionPlan plan, double now_s) {
  const std::uint32_t plan_id = plan.plan_id;
  if (!isNew(plan_id)) {
    return;
  }
  if (plan_id > plan_id_ && plan_id <= last_plan_id_) {
    setRefused(plan_id, "its id is not greater than " + std::to_string(last_plan_id_) +
                            ", which is the last one in use");
    return;
  }
  if (plan.replaces_plan_id == 0) {
    makeRoomFor(plan_id);
  }
  if (const auto fault = faultOf(plan)) {
    setRefused(plan_id, *fault);
    return;
  }
  pending_ = std::make_shared<const MissionPlan>(std::move(plan));
  pending_until_s_ = now_s + limits_.start_wait_s;
  tryStart(now_s);
  advance();
}

void Execution::makeRoomFor(std::uint32_t plan_id) {
  refusal_.clear();
  plan_id_ = plan_id;
  last_plan_id_ = plan_id;
  if (graph_ && !is_abandoned_) {
    is_abandoned_ = true;
    log({Kind::Abandoned, plan_->plan_id, -1, 0, "a new mission takes its place"});
  }
  setPhase(ExecutionPhase::Pending);
}

void Execution::tryStart(double now_s) {
  if (!pending_) {
    return;
  }
  const std::uint32_t plan_id = pending_->plan_id;
  if (const auto wait = reasonToWait(now_s)) {
    if (now_s > pending_until_s_) {
      setRefused(plan_id, *wait);
    }
    return;
  }
  if (const auto fault = reasonNotAtStart(*pending_)) {
    setRefused(plan_id, *fault);
    return;
  }
  try {
    load(std::exchange(pending_, nullptr));
  } catch (const PlanRefused& refused) {
    setRefused(plan_id, refused.what());
  }
}

std::optional<std::string> Execution::faultOf(const MissionPlan& plan) const {
  std::set<std::string> members;
  for (const std::string& robot : plan.robots) {
    const std::optional<int> known = indexOf(robot);
    if (!known) {
      return "robot '" + robot + "' is not in the lab";
    }
    if (!members.insert(robot).second) {
      return robot + " appears twice";
    }
    if (plan.replaces_plan_id != 0 && robots_[index(*known)].monitor.isLost()) {
      return robot + " is lost and cannot take part";
    }
  }
  if (plan.first_step != 0) {
    return "it begins at timestep " + std::to_string(plan.first_step) + ": must be 0";
  }
  if (plan.plan.empty() || plan.goals.size() != plan.robots.size() ||
      plan.social.size() != plan.steps()) {
    return "it is not complete";
  }
  if (plan.replaces_plan_id != 0) {
    if (!plan_ || plan.replaces_plan_id != plan_->plan_id) {
      return "it replaces plan " + std::to_string(plan.replaces_plan_id) + ", but plan " +
             std::to_string(plan_ ? plan_->plan_id : 0) + " is carried out";
    }
    if (!is_cut_) {
      return "it replaces a plan that is not cut: no robot has been declared lost";
    }
  }
  // The graph names robots, so it goes first; the independent checker has the last word.
  try {
    const ActionDependencyGraph graph(plan.plan, plan.robots);
  } catch (const PlanRefused& refused) {
    return refused.what();
  }
  const auto violation =
      checkPlan({Grid(rows_, cols_), plan.plan.front(), plan.goals, MotionModel{false}}, plan.plan);
  return violation ? std::make_optional(violation->message) : std::nullopt;
}

std::optional<std::string> Execution::reasonToWait(double now_s) const {
  for (int robot = 0; robot < robotCount(); ++robot) {
    if (!robots_[index(robot)].monitor.isLost() && hasReleased(robot)) {
      return name(robot) + " has not finished the tasks of plan " + std::to_string(plan_->plan_id) +
             " that it has";
    }
  }
  for (const std::string& member : pending_->robots) {
    const RobotMonitor& robot = robots_[index(*indexOf(member))].monitor;
    if (!robot.isHeard(now_s)) {
      return member + " does not report";
    }
    const RobotReport& report = *robot.report();
    if (report.state == RobotState::Blind || !report.pose) {
      return member + " has no good pose" +
             (report.detail.empty() ? std::string() : ": " + report.detail);
    }
    if (report.state == RobotState::Moving) {
      return member + " still moves";
    }
    if (plan_ && report.plan_id == plan_->plan_id && report.done < report.accepted) {
      return member + " has not finished the tasks of plan " + std::to_string(plan_->plan_id);
    }
  }
  return std::nullopt;
}

std::optional<std::string> Execution::reasonNotAtStart(const MissionPlan& plan) const {
  std::set<int> members;
  for (std::size_t agent = 0; agent < plan.robots.size(); ++agent) {
    const int robot = *indexOf(plan.robots[agent]);
    members.insert(robot);
    const Point place = position(robots_[index(robot)].monitor.report()->pose.value());
    const Cell start = plan.plan.front()[agent];
    const Cell cell = frame_.toCell(place);
    if (cell != start) {
      return "it starts " + name(robot) + " in " + toString(start) + ", but the robot is in " +
             toString(cell);
    }
    const Point center = frame_.toPoint(start);
    const double offset_m = std::max(std::abs(place.x - center.x), std::abs(place.y - center.y));
    if (offset_m > limits_.start_offset_m) {
      return name(robot) + " stands " + metres(offset_m) + " off the centre of its start " +
             toString(start) + ": at most " + metres(limits_.start_offset_m) + " are allowed";
    }
  }
  std::set<Cell> visited;
  for (const Configuration& cells : plan.plan) {
    visited.insert(cells.begin(), cells.end());
  }
  for (int robot = 0; robot < robotCount(); ++robot) {
    const std::optional<RobotReport>& report = robots_[index(robot)].monitor.report();
    if (members.count(robot) > 0 || !report || !report->pose) {
      continue;
    }
    const Cell cell = frame_.toCell(position(*report->pose));
    if (visited.count(cell) > 0) {
      return "it leads through " + toString(cell) + ", where " + name(robot) +
             " stands, which takes no part";
    }
  }
  return std::nullopt;
}

void Execution::load(std::shared_ptr<const MissionPlan> plan) {
  if (!plan || plan->plan.empty()) {
    throw std::invalid_argument("there is no plan to carry out");
  }
  if (plan->replaces_plan_id == 0) {
    loadMission(*plan);
  } else {
    loadReplacement(*plan);
  }
  plan_ = std::move(plan);
  plan_id_ = plan_->plan_id;
  last_plan_id_ = std::max(last_plan_id_, plan_id_);
  is_cut_ = false;
  is_abandoned_ = false;
  refusal_.clear();
  for (Robot& robot : robots_) {
    robot.accepted = 0;
    robot.sent_s.clear();
    robot.waits_since_s.reset();
  }
  ExecutionEvent event;
  event.kind = Kind::Started;
  event.plan_id = plan_id_;
  event.plan = plan_;
  log(std::move(event));
  setPhase(ExecutionPhase::Executing);
}

void Execution::loadMission(const MissionPlan& plan) {
  Plan whole(plan.plan.size(), Configuration(names_.size()));
  for (Configuration& cells : whole) {
    for (int robot = 0; robot < robotCount(); ++robot) {
      cells[index(robot)] = nowhere(robot);
    }
  }
  for (std::size_t t = 0; t < whole.size(); ++t) {
    for (std::size_t agent = 0; agent < plan.robots.size(); ++agent) {
      whole[t][index(indexOf(plan.robots[agent]).value())] = plan.plan[t].at(agent);
    }
  }
  graph_.emplace(ActionDependencyGraph(whole, names_));
  mission_goals_.clear();
  for (std::size_t agent = 0; agent < plan.robots.size(); ++agent) {
    const int robot = indexOf(plan.robots[agent]).value();
    mission_goals_[robot] = plan.goals.at(agent);
    robots_[index(robot)].monitor.rejoin();
  }
  for (Robot& robot : robots_) {
    robot.first_sequence = 0;
  }
}

void Execution::loadReplacement(const MissionPlan& plan) {
  if (!graph_) {
    throw std::invalid_argument("there is no plan to replace");
  }
  CommitCut cut;
  for (int robot = 0; robot < robotCount(); ++robot) {
    cut.push_back(graph_->releasedCount(robot));
  }
  std::vector<AgentId> agents;
  for (const std::string& robot : plan.robots) {
    agents.push_back(indexOf(robot).value());
  }
  graph_->replaceRest(cut, agents, plan.plan);
  for (int robot = 0; robot < robotCount(); ++robot) {
    robots_[index(robot)].first_sequence = cut[index(robot)];
  }
}

}  // namespace sylph
