#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sylph_core/geometry/segment.hpp"

namespace sylph_rehearsal {
namespace {

/// A robot's centre may be so far outside the cells that it holds [m].
constexpr double kCellMargin_m = 0.02;
/// A task that is told to be done has ended so close to where it should [m].
constexpr double kArrival_m = 0.04;
/// A robot that has to stop is at rest after this.
constexpr double kStop_s = 1.0;
constexpr double kRest_mps = 0.03;

std::string millimetres(double value_m) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.0f mm", value_m * 1e3);
  return text;
}

/// How far a point lies outside a cell; 0 inside [m].
double distanceOutside(const sylph::CellFrame& frame, const sylph::Cell& cell,
                       const sylph::Point& point) {
  const sylph::Point center = frame.toPoint(cell);
  const double half_m = frame.cellSize() / 2.0;
  return std::max(
      {0.0, std::abs(point.x - center.x) - half_m, std::abs(point.y - center.y) - half_m});
}

}  // namespace

Oracle::Oracle(const sylph::Experiment& experiment)
    : experiment_(&experiment), frame_(cellFrameOf(experiment)) {
  for (const sylph::RobotSpec& spec : experiment.robots) {
    Robot robot;
    robot.way = {spec.start};
    robot.place = frame_.toPoint(spec.start);
    robots_.push_back(robot);
  }
}

void Oracle::onStarted(const sylph::MissionPlan& plan) {
  plan_id_ = plan.plan_id;
  leaves_.clear();
  for (std::size_t agent = 0; agent < plan.robots.size(); ++agent) {
    const auto spec = std::find_if(
        experiment_->robots.begin(), experiment_->robots.end(),
        [&](const sylph::RobotSpec& robot) { return robot.name == plan.robots[agent]; });
    const auto index = static_cast<std::size_t>(spec - experiment_->robots.begin());
    Robot& robot = robots_.at(index);
    robot.way = {plan.plan.front()[agent]};
    robot.done = 0;
    for (std::size_t step = 0; step + 1 < plan.plan.size(); ++step) {
      const sylph::Cell& from = plan.plan[step][agent];
      const sylph::Cell& to = plan.plan[step + 1][agent];
      if (from != to) {
        leaves_[from].push_back(
            {static_cast<sylph::Timestep>(step), index, static_cast<int>(robot.way.size()) - 1});
        robot.way.push_back(to);
      }
    }
  }
}

void Oracle::onOrder(const sylph::TaskOrder& order, double time_s) {
  if (order.plan_id != plan_id_ || order.status != sylph::TaskStatus::Enqueued) {
    return;
  }
  const auto entered = static_cast<std::size_t>(order.robot);
  // By the plan itself and not by the graph, which is what is judged here: everybody who leaves a
  // cell in an earlier step has to be out of it.
  const auto found = leaves_.find(order.end);
  if (found == leaves_.end()) {
    return;
  }
  for (const Leave& leave : found->second) {
    if (leave.robot != entered && leave.timestep <= order.timestep &&
        robots_[leave.robot].done <= leave.sequence) {
      violate(time_s, name(entered) + " is sent into " + toString(order.end) + ", which " +
                          name(leave.robot) + " has not left");
    }
  }
}

void Oracle::onReport(std::size_t index, const sylph::RobotReport& report,
                      const sylph::Point& place, double time_s) {
  Robot& robot = robots_[index];
  if (report.plan_id != plan_id_ || report.done <= robot.done) {
    return;  // a node that started again counts from 0
  }
  const auto done = static_cast<std::size_t>(report.done);
  if (done >= robot.way.size()) {
    violate(time_s, name(index) + " tells of more tasks than it has");
    return;
  }
  robot.done = report.done;
  const std::size_t next = std::min(done + 1, robot.way.size() - 1);
  const double off_m =
      distanceToSegment(place, frame_.toPoint(robot.way[done]), frame_.toPoint(robot.way[next]));
  if (off_m > kArrival_m && !robot.is_pushed) {
    violate(time_s, name(index) + " tells that it is in " + toString(robot.way[done]) + " and is " +
                        millimetres(off_m) + " off");
  }
}

void Oracle::onStopHeard(std::size_t robot, double time_s) {
  robots_[robot].stopped_s = robots_[robot].stopped_s.value_or(time_s);
}

void Oracle::onResumed() {
  for (Robot& robot : robots_) {
    robot.stopped_s.reset();
  }
}

void Oracle::check(const sylph_sim::Simulation& simulation, double time_s) {
  if (simulation.collisions() > collisions_) {
    collisions_ = simulation.collisions();
    violate(time_s, "two robots touch");
  }
  if (simulation.obstacleEntries() > obstacle_entries_) {
    obstacle_entries_ = simulation.obstacleEntries();
    violate(time_s, "a robot enters an obstacle");
  }
  for (std::size_t index = 0; index < robots_.size(); ++index) {
    Robot& robot = robots_[index];
    const sylph::Point before = robot.place;
    robot.place = sylph::position(simulation.poses()[index]);
    // Who was pushed from outside is where it should not be by no fault of the suite.
    if (!robot.is_pushed) {
      checkPlace(index, time_s);
      checkRest(index, before, simulation.stepDuration(), time_s);
    }
  }
}

void Oracle::checkPlace(std::size_t index, double time_s) {
  const Robot& robot = robots_[index];
  const auto done = static_cast<std::size_t>(robot.done);
  double outside_m = distanceOutside(frame_, robot.way[done], robot.place);
  if (done + 1 < robot.way.size()) {
    outside_m = std::min(outside_m, distanceOutside(frame_, robot.way[done + 1], robot.place));
  }
  if (outside_m > kCellMargin_m) {
    violate(time_s,
            name(index) + " is " + millimetres(outside_m) + " outside the cells that it holds");
  }
}

void Oracle::checkRest(std::size_t index, const sylph::Point& before, double step_s,
                       double time_s) {
  const Robot& robot = robots_[index];
  if (robot.stopped_s && time_s - *robot.stopped_s > kStop_s &&
      distance(before, robot.place) > kRest_mps * step_s) {
    violate(time_s, name(index) + " moves although it was told to stop");
  }
}

}  // namespace sylph_rehearsal
