#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/adg/explanation.hpp"

namespace sylph::test {

inline constexpr int kRows = 5;
inline constexpr int kCols = 6;
inline constexpr double kCellSize = 0.3;

/// A mission whose goals are where the plan ends, with partners and SVOs that tell agents apart.
inline MissionPlan missionPlan(const Plan& plan, std::vector<std::string> robots,
                               std::uint32_t plan_id, std::uint32_t replaces_plan_id = 0) {
  MissionPlan mission;
  mission.plan_id = plan_id;
  mission.replaces_plan_id = replaces_plan_id;
  mission.planner = "test";
  mission.robots = std::move(robots);
  mission.goals = plan.back();
  mission.plan = plan;
  const std::size_t agents = plan.front().size();
  SocialState social;
  for (std::size_t agent = 0; agent < agents; ++agent) {
    social.partners.push_back(agent == 0 ? 0 : static_cast<AgentId>(agent) - 1);
    social.svo_deg.push_back(static_cast<float>(agent) * 5.0F);
  }
  mission.social.assign(plan.size() - 1, social);
  return mission;
}

/// A robot at the other end: keeps to the protocol, remembers what it has carried out.
struct Robot {
  std::uint32_t report_id = 0;
  std::uint32_t plan_id = 0;
  int done = 0;
  std::map<int, TaskOrder> tasks;
  Point position;
  double yaw_rad = 0.0;
  std::optional<RobotState> state;  ///< that it tells in place of the one that its tasks give
  std::string detail;
  std::vector<int> carried_out;  ///< sequences of the present plan

  int accepted() const {
    int count = 0;
    while (tasks.count(count) > 0) {
      ++count;
    }
    return count;
  }
  void take(const TaskOrder& order) {
    if (order.plan_id < plan_id) {
      return;
    }
    if (order.plan_id > plan_id) {
      plan_id = order.plan_id;
      done = 0;
      tasks.clear();
      carried_out.clear();
    }
    tasks.emplace(order.sequence, order);
    while (tasks.count(done) > 0 && tasks.at(done).status == TaskStatus::Done) {
      ++done;
    }
  }
  bool hasTask() const { return done < accepted(); }
  void carryOut(const CellFrame& frame) {
    position = frame.toPoint(tasks.at(done).end);
    carried_out.push_back(done);
    ++done;
  }
  RobotReport report(double stamp_s) {
    RobotReport report;
    report.report_id = ++report_id;
    report.stamp_s = stamp_s;
    report.plan_id = plan_id;
    report.accepted = accepted();
    report.done = done;
    report.state = state.value_or(hasTask() ? RobotState::Moving : RobotState::Idle);
    report.detail = detail;
    report.pose = Pose2d{position.x, position.y, yaw_rad};
    report.heading_error_rad = yaw_rad;
    return report;
  }
};

/// A queue of three that moves two cells east, robot 2 in front.
inline Plan queue() {
  return {{{0, 0}, {0, 1}, {0, 2}}, {{0, 1}, {0, 2}, {0, 3}}, {{0, 2}, {0, 3}, {0, 4}}};
}

/// An Execution with robots around it and a clock that the test moves.
class ExecutionTest : public testing::Test {
 protected:
  explicit ExecutionTest(int robots = 3) : frame_(kRows, kCellSize), robots_(index(robots)) {
    for (int robot = 0; robot < robots; ++robot) {
      names_.push_back("robot_" + std::to_string(robot));
    }
    limits_.lookahead = 3;
    restart();
  }

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// A new Execution that knows nothing.
  void restart() { execution_.emplace(names_, kRows, kCols, kCellSize, limits_); }

  void place(const Configuration& cells) {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      robots_[i].position = frame_.toPoint(cells[i]);
      report(static_cast<int>(i));
    }
  }

  void report(int robot) {
    execution_->report(robot, robots_[index(robot)].report(now_s_), now_s_);
  }
  void reportAll() {
    for (int robot = 0; robot < execution_->robotCount(); ++robot) {
      report(robot);
    }
  }

  /// Hands out what there is to send and keeps the log.
  void deliver() {
    collect();
    for (const TaskOrder& order : execution_->takeOrders(now_s_)) {
      robots_[index(order.robot)].take(order);
    }
  }
  void collect() {
    for (ExecutionEvent& event : execution_->takeEvents()) {
      log_.push_back(std::move(event));
    }
  }

  /// Time passes; robots that are not in `idle` carry out a task each and report.
  void step(const std::set<int>& idle = {}, double duration_s = 0.1) {
    now_s_ += duration_s;
    for (int i = 0; i < execution_->robotCount(); ++i) {
      if (idle.count(i) > 0) {
        continue;
      }
      if (robots_[index(i)].hasTask()) {
        robots_[index(i)].carryOut(frame_);
      }
      report(i);
    }
    execution_->tick(now_s_);
    deliver();
  }

  bool stepUntil(ExecutionPhase phase, const std::set<int>& idle = {}) {
    for (int i = 0; i < 300 && execution_->phase() != phase; ++i) {
      step(idle);
    }
    return execution_->phase() == phase;
  }

  template <typename Event>
  int count() const {
    return static_cast<int>(std::count_if(log_.begin(), log_.end(), [](const auto& entry) {
      return std::holds_alternative<Event>(entry.what);
    }));
  }

  RobotExecution view(int robot) const { return explain(*execution_, robot, now_s_); }

  void submit(const Plan& plan, std::uint32_t plan_id, std::uint32_t replaces_plan_id = 0,
              std::vector<std::string> robots = {}) {
    execution_->submit(
        missionPlan(plan, robots.empty() ? names_ : std::move(robots), plan_id, replaces_plan_id),
        now_s_);
    deliver();
  }

  CellFrame frame_;
  std::vector<std::string> names_;
  ExecutionLimits limits_;
  std::optional<Execution> execution_;
  std::vector<Robot> robots_;
  std::vector<ExecutionEvent> log_;
  double now_s_ = 100.0;
};

}  // namespace sylph::test
