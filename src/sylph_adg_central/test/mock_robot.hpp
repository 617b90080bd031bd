#pragma once

#include <ros/ros.h>
#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/grid/cell_frame.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_adg_central::test {

/// What goes wrong between a mock robot and the central node.
struct Faults {
  int drop_task_every = 0;           ///< each k-th task message is lost, 0: none
  int drop_report_every = 0;         ///< each k-th report is lost, 0: none
  bool doubles_reports = false;      ///< each report is sent twice
  bool repeats_old_reports = false;  ///< the first report of the run comes again behind each report
};

/// Answers tasks as a robot does, at a pace of one task a step. It moves when the test says so.
class MockRobot {
 public:
  MockRobot(ros::NodeHandle nh, std::string name, const sylph::CellFrame& frame,
            const sylph::Point& position)
      : name_(std::move(name)), frame_(frame), position_(position) {
    publisher_ = nh.advertise<sylph_msgs::TaskReport>(
        sylph_ros::robotTopic(nh, name_, sylph_ros::kTaskReportTopic), 100);
    subscriber_ = nh.subscribe(sylph_ros::robotTopic(nh, name_, sylph_ros::kTaskTopic), 1000,
                               &MockRobot::onTask, this);
  }

  bool isConnected() const {
    return publisher_.getNumSubscribers() > 0 && subscriber_.getNumPublishers() > 0;
  }

  /// Carries out its next task, if it has one, and reports.
  void step() {
    if (!is_halted && done_ < accepted()) {
      const sylph_msgs::Task& task = tasks_.at(done_);
      position_ = {task.end_pos.x, task.end_pos.y};
      ++done_;
      carried_out.push_back(task);
    }
    report();
  }

  void report() {
    if (is_silent) {
      return;
    }
    sylph_msgs::TaskReport message;
    message.header.stamp = ros::Time::now();
    message.header.frame_id = sylph_ros::kMapFrame;
    message.robot_id = name_;
    message.report_id = ++report_id_;
    message.plan_id = plan_id_;
    message.accepted = accepted();
    message.done = done_;
    message.state = is_blind             ? sylph_msgs::TaskReport::BLIND
                    : done_ < accepted() ? sylph_msgs::TaskReport::MOVING
                                         : sylph_msgs::TaskReport::IDLE;
    message.x = position_.x;
    message.y = position_.y;
    message.tracking_error_m = 0.004;
    send(message);
  }

  /// The robot's node starts again: it forgets its tasks and counts.
  void restart() {
    plan_id_ = 0;
    done_ = 0;
    report_id_ = 0;
    tasks_.clear();
  }

  const sylph::Point& position() const { return position_; }
  void setPosition(const sylph::Point& position) { position_ = position; }
  std::uint32_t done() const { return done_; }
  std::uint32_t planId() const { return plan_id_; }
  /// Tasks without a gap.
  std::uint32_t accepted() const {
    std::uint32_t count = 0;
    while (tasks_.count(count) > 0) {
      ++count;
    }
    return count;
  }
  bool hasTask() const { return done_ < accepted(); }

  Faults faults;
  bool is_silent = false;  ///< neither reports nor hears
  bool is_halted = false;  ///< reports, but does not move
  bool is_blind = false;
  std::vector<sylph_msgs::Task> carried_out;

 private:
  void onTask(const sylph_msgs::Task& task) {
    ++tasks_heard_;
    if (is_silent || (faults.drop_task_every > 0 && tasks_heard_ % faults.drop_task_every == 0) ||
        task.plan_id < plan_id_) {
      return;
    }
    if (task.plan_id > plan_id_) {
      plan_id_ = task.plan_id;
      done_ = 0;
      tasks_.clear();
    }
    tasks_[task.sequence] = task;
    while (tasks_.count(done_) > 0 && tasks_.at(done_).status == sylph_msgs::Task::DONE) {
      ++done_;
    }
  }

  void send(const sylph_msgs::TaskReport& message) {
    ++reports_sent_;
    if (!first_report_) {
      first_report_ = message;
    }
    if (faults.drop_report_every > 0 && reports_sent_ % faults.drop_report_every == 0) {
      return;
    }
    publisher_.publish(message);
    if (faults.doubles_reports) {
      publisher_.publish(message);
    }
    if (faults.repeats_old_reports) {
      publisher_.publish(*first_report_);
    }
  }

  std::string name_;
  sylph::CellFrame frame_;
  sylph::Point position_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  std::uint32_t plan_id_ = 0;
  std::uint32_t done_ = 0;
  std::uint32_t report_id_ = 0;
  std::map<std::uint32_t, sylph_msgs::Task> tasks_;
  std::optional<sylph_msgs::TaskReport> first_report_;
  int tasks_heard_ = 0;
  int reports_sent_ = 0;
};

}  // namespace sylph_adg_central::test
