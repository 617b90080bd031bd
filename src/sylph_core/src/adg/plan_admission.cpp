#include "sylph_core/adg/plan_admission.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/text/format.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph {
namespace {

/// How far a robot is off, and what it says to that.
std::string offsetOf(const Pose2d& target, const RobotReport& report) {
  return format("%.0f mm and ", distance(position(target), position(*report.pose)) * 1e3) +
         format("%.0f deg off", std::abs(report.heading_error_rad) * 180.0 / M_PI) +
         (report.detail.empty() ? std::string() : ": " + report.detail);
}

}  // namespace

PlanAdmission::PlanAdmission(std::vector<std::string> robots, int rows, int cols,
                             const CellFrame& frame, ExecutionLimits limits)
    : names_(std::move(robots)), map_(rows, cols), frame_(frame), limits_(std::move(limits)) {
  for (std::size_t robot = 0; robot < names_.size(); ++robot) {
    indices_.emplace(names_[robot], robot);
  }
}

std::optional<std::size_t> PlanAdmission::indexOf(const std::string& robot) const {
  const auto found = indices_.find(robot);
  return found == indices_.end() ? std::nullopt : std::make_optional(found->second);
}

std::optional<std::string> PlanAdmission::propose(MissionPlan plan, const PresentExecution& present,
                                                  double now_s) {
  if (auto fault = faultOf(plan, present)) {
    return fault;
  }
  pending_ = std::make_shared<const MissionPlan>(std::move(plan));
  pending_until_s_ = now_s + limits_.start_wait_s;
  return std::nullopt;
}

PlanAdmission::Decision PlanAdmission::decide(const PresentExecution& present, double now_s) const {
  if (const auto wait = reasonToWait(present, now_s)) {
    return {now_s > pending_until_s_ ? Decision::Verdict::Refuse : Decision::Verdict::Wait, *wait};
  }
  if (const auto fault = reasonNotNew(present)) {
    return {Decision::Verdict::Refuse, *fault};
  }
  if (const auto fault = bystanderInTheWay(present)) {
    return {Decision::Verdict::Refuse, *fault};
  }
  if (limits_.alignment && pending_->replaces_plan_id == 0) {
    if (const auto decision = decideOnAlignment(present, now_s)) {
      return *decision;
    }
  }
  if (const auto fault = reasonNotAtStart(present)) {
    // At a cut a robot may still be on its way back to the centre of its cell.
    const bool may_come = pending_->replaces_plan_id != 0 && now_s <= pending_until_s_;
    return {may_come ? Decision::Verdict::Wait : Decision::Verdict::Refuse, *fault};
  }
  return {Decision::Verdict::Start, {}};
}

std::optional<std::vector<std::size_t>> PlanAdmission::agentsToAlign(
    const PresentExecution& present) const {
  std::vector<std::size_t> agents;
  for (std::size_t agent = 0; agent < pending_->robots.size(); ++agent) {
    const std::size_t robot = *indexOf(pending_->robots[agent]);
    const RobotReport& report = *present.monitors[robot].report();
    const Cell& start = pending_->plan.front()[agent];
    if (frame_.toCell(position(*report.pose)) != start) {
      return std::nullopt;
    }
    const bool is_under_way = present.aligned == robot;
    if (!isInMiddle(start, *report.pose) || (is_under_way && report.state == RobotState::Moving)) {
      // Who is under way comes to its end first.
      agents.insert(is_under_way ? agents.begin() : agents.end(), agent);
    }
  }
  return agents;
}

AlignmentQuestion PlanAdmission::alignmentOf(std::size_t agent,
                                             const PresentExecution& present) const {
  AlignmentQuestion question;
  question.robot = *indexOf(pending_->robots[agent]);
  for (const RobotMonitor& monitor : present.monitors) {
    question.poses.push_back(monitor.report() ? monitor.report()->pose : std::nullopt);
  }
  const Point center = frame_.toPoint(pending_->plan.front()[agent]);
  const RobotReport& report = *present.monitors[question.robot].report();
  question.target = {center.x, center.y, report.pose->yaw_rad - report.heading_error_rad};
  question.is_under_way = present.aligned == question.robot;
  return question;
}

std::optional<PlanAdmission::Decision> PlanAdmission::decideOnAlignment(
    const PresentExecution& present, double now_s) const {
  using Verdict = Decision::Verdict;
  const auto agents = agentsToAlign(present);
  if (!agents || agents->empty()) {
    return std::nullopt;  // all are aligned, or one has to be carried to its start
  }
  std::vector<std::string> reasons;
  for (const std::size_t agent : *agents) {
    const AlignmentQuestion question = alignmentOf(agent, present);
    const RobotReport& report = *present.monitors[question.robot].report();
    const auto reason = reasonNotToAlign(question, names_, frame_, *limits_.alignment);
    const std::string& name = names_[question.robot];
    if (!reason) {
      const bool is_late = question.is_under_way && now_s > pending_until_s_;
      return Decision{is_late ? Verdict::Refuse : Verdict::Align,
                      name + " is being aligned, " + offsetOf(question.target, report),
                      question.robot};
    }
    if (question.is_under_way && report.state == RobotState::Moving) {
      return Decision{Verdict::Wait, name + " " + *reason, question.robot};
    }
    reasons.push_back(name + " " + *reason);
  }
  return Decision{Verdict::Refuse, join(reasons, "\n"), 0};
}

std::optional<std::string> PlanAdmission::faultOfMembers(const MissionPlan& plan) const {
  std::set<std::string> members;
  for (const std::string& robot : plan.robots) {
    const auto known = indexOf(robot);
    if (!known) {
      return "robot '" + robot + "' is not in the lab";
    }
    if (!members.insert(robot).second) {
      return robot + " appears twice";
    }
  }
  return std::nullopt;
}

std::optional<std::string> PlanAdmission::faultOf(const MissionPlan& plan,
                                                  const PresentExecution& present) const {
  if (auto fault = faultOfMembers(plan)) {
    return fault;
  }
  if (plan.first_step != 0) {
    return "it begins at timestep " + std::to_string(plan.first_step) + ": must be 0";
  }
  if (plan.plan.empty() || plan.goals.size() != plan.robots.size() ||
      plan.social.size() != plan.steps()) {
    return "it is not complete";
  }
  if (plan.replaces_plan_id != 0) {
    const std::uint32_t carried_out = present.plan != nullptr ? present.plan->plan_id : 0;
    if (plan.replaces_plan_id != carried_out) {
      return "it replaces plan " + std::to_string(plan.replaces_plan_id) + ", but plan " +
             std::to_string(carried_out) + " is carried out";
    }
    if (!present.is_cut) {
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
      checkPlan({map_, plan.plan.front(), plan.goals, MotionModel{false}}, plan.plan);
  return violation ? std::make_optional(violation->message) : std::nullopt;
}

std::optional<std::string> PlanAdmission::reasonToWait(const PresentExecution& present,
                                                       double now_s) const {
  // Released tasks of the present plan may be on their way or under way; a new plan that knows
  // nothing of them must not begin.
  for (std::size_t robot = 0; present.graph != nullptr && robot < names_.size(); ++robot) {
    const auto agent = static_cast<AgentId>(robot);
    if (!present.monitors[robot].isLost() &&
        present.graph->doneCount(agent) < present.graph->releasedCount(agent)) {
      return names_[robot] + " has not finished the tasks of plan " +
             std::to_string(present.plan->plan_id) + " that it has";
    }
  }
  // All that are waited for: one that has no pose at this moment must not hide one that is not
  // there.
  std::vector<std::string> silent;
  std::vector<std::string> others;
  for (const std::string& member : pending_->robots) {
    const std::size_t robot = *indexOf(member);
    if (!present.monitors[robot].isHeard(now_s)) {
      silent.push_back(member + " does not report");
    } else if (const auto reason = reasonToWaitFor(robot, present)) {
      others.push_back(member + " " + *reason);
    }
  }
  silent.insert(silent.end(), others.begin(), others.end());
  return silent.empty() ? std::nullopt : std::make_optional(join(silent, "; "));
}

std::optional<std::string> PlanAdmission::reasonToWaitFor(std::size_t robot,
                                                          const PresentExecution& present) {
  const RobotReport& report = *present.monitors[robot].report();
  if (report.state == RobotState::Blind || !report.pose) {
    return "has no good pose" + (report.detail.empty() ? std::string() : ": " + report.detail);
  }
  // It may still coast out of the cell in which it was seen.
  if (report.state == RobotState::Moving && present.aligned != robot) {
    return "still moves";
  }
  if (present.plan != nullptr && report.plan_id == present.plan->plan_id &&
      report.done < report.accepted) {
    return "has not finished the tasks of plan " + std::to_string(present.plan->plan_id);
  }
  return std::nullopt;
}

std::optional<std::string> PlanAdmission::reasonNotNew(const PresentExecution& present) const {
  for (const std::string& name : pending_->robots) {
    // Its tasks done of another plan of this id would count for this one.
    const std::uint32_t known = present.monitors[*indexOf(name)].report()->plan_id;
    if (known >= pending_->plan_id) {
      return name + " has tasks of plan " + std::to_string(known) +
             " from before the central node was launched: send the mission again";
    }
  }
  return std::nullopt;
}

std::optional<std::string> PlanAdmission::reasonNotAtStart(const PresentExecution& present) const {
  std::vector<std::string> reasons;
  for (std::size_t agent = 0; agent < pending_->robots.size(); ++agent) {
    const std::string& name = pending_->robots[agent];
    const Pose2d& pose = present.monitors[*indexOf(name)].report()->pose.value();
    if (const auto reason = reasonNotIn(pending_->plan.front()[agent], pose)) {
      reasons.push_back(name + " " + *reason);
    }
  }
  return reasons.empty() ? std::nullopt : std::make_optional(join(reasons, "\n"));
}

std::optional<std::string> PlanAdmission::reasonNotIn(const Cell& start, const Pose2d& pose) const {
  const Cell cell = frame_.toCell(position(pose));
  if (cell != start) {
    return "is in " + toString(cell) + ", and not in its start " + toString(start);
  }
  if (isInMiddle(start, pose)) {
    return std::nullopt;
  }
  const Vector2 offset = displacement(frame_.toPoint(start), position(pose));
  const Vector2 free = freedomOf(pose);
  char text[160];
  std::snprintf(text, sizeof(text),
                "stands %.0f mm in x and %.0f mm in y off the centre of its start %s, turned by "
                "%.0f deg: allowed are %.0f and %.0f mm, turned like that",
                offset.x * 1e3, offset.y * 1e3, toString(start).c_str(),
                pose.yaw_rad * 180.0 / M_PI, std::max(0.0, free.x) * 1e3,
                std::max(0.0, free.y) * 1e3);
  return text;
}

Vector2 PlanAdmission::freedomOf(const Pose2d& pose) const {
  // The footprint has to stay in the middle of the cell, as that of a robot which keeps to its
  // tolerances; a neighbour may come as near to the edge. Turned it needs a larger box.
  const StartLimits& limits = limits_.start;
  const Vector2 box = halfBox(limits.length_m, limits.width_m, pose.yaw_rad);
  return {limits.room_m - box.x, limits.room_m - box.y};
}

bool PlanAdmission::isInMiddle(const Cell& start, const Pose2d& pose) const {
  const Vector2 offset = displacement(frame_.toPoint(start), position(pose));
  const Vector2 free = freedomOf(pose);
  return std::abs(offset.x) <= free.x && std::abs(offset.y) <= free.y;
}

std::optional<std::string> PlanAdmission::bystanderInTheWay(const PresentExecution& present) const {
  // Cells that the plan touches at any time: it is not known when a bystander goes away.
  std::set<Cell> visited;
  for (const Configuration& cells : pending_->plan) {
    visited.insert(cells.begin(), cells.end());
  }
  const std::set<std::string> members(pending_->robots.begin(), pending_->robots.end());
  for (std::size_t robot = 0; robot < names_.size(); ++robot) {
    const std::optional<RobotReport>& report = present.monitors[robot].report();
    if (!report || !report->pose || members.count(names_[robot]) > 0) {
      continue;
    }
    const Pose2d& pose = *report->pose;
    const StartLimits& limits = limits_.start;
    // As far as a robot in the next cell may reach towards it.
    const double beyond_m = frame_.cellSize() / 2.0 - limits.room_m;
    for (const Cell& cell :
         frame_.cellsUnder(position(pose), halfBox(limits.length_m, limits.width_m, pose.yaw_rad) +
                                               Vector2{beyond_m, beyond_m})) {
      if (visited.count(cell) > 0) {
        return "it leads through " + toString(cell) + ", where " + names_[robot] +
               " stands, which takes no part";
      }
    }
  }
  return std::nullopt;
}

}  // namespace sylph
