#include "sylph_rviz/goal_markers.hpp"

#include <visualization_msgs/InteractiveMarker.h>

#include <algorithm>
#include <utility>

#include "sylph_ros/topics.hpp"
#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;

// Names of the server's markers begin with these.
constexpr char kRobot[] = "robot ";
constexpr char kGoal[] = "goal ";

// RViz picks what lies on top, however faint it is drawn: what is to be picked lies above all
// layers.
constexpr double kPickedAlpha = 0.02;
constexpr double kRobotPickedM = height::kText + 0.01;
constexpr double kGoalPickedM = height::kText + 0.02;

InteractiveMarker makeInteractive(const std::string& name, const std::string& frame,
                                  std::uint8_t mode, Marker shape) {
  InteractiveMarker marker;
  marker.header.frame_id = frame;  // with stamp 0 it moves with its frame
  marker.name = name;
  marker.scale = 1.0F;
  marker.pose.orientation.w = 1.0;
  shape.header = std_msgs::Header();
  InteractiveMarkerControl control;
  control.name = "control";
  control.always_visible = 1;
  control.interaction_mode = mode;
  // The plane of the floor: its normal is the x axis of the control.
  control.orientation.w = control.orientation.y = 0.7071067811865476;
  control.orientation_mode = InteractiveMarkerControl::INHERIT;
  control.independent_marker_orientation = 1;
  control.markers.push_back(std::move(shape));
  marker.controls.push_back(std::move(control));
  return marker;
}

geometry_msgs::Pose poseAt(const sylph::Point& point) {
  geometry_msgs::Pose pose;
  pose.position.x = point.x;
  pose.position.y = point.y;
  pose.orientation.w = 1.0;
  return pose;
}

bool isSame(const std::optional<sylph::Point>& a, const std::optional<sylph::Point>& b) {
  return a.has_value() == b.has_value() && (!a || (a->x == b->x && a->y == b->y));
}

}  // namespace

GoalMarkers::GoalMarkers(const ros::NodeHandle& suite_nh)
    : server_(suite_nh.resolveName(sylph_ros::kGoalMarkersTopic), "", true) {}

std::vector<GoalEvent> GoalMarkers::takeEvents() {
  std::vector<GoalEvent> events;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    events = std::exchange(events_, {});
  }
  for (const GoalEvent& event : events) {
    if (event.kind == GoalEvent::Kind::Drag) {
      dragged_ = event.robot;
    } else if (event.kind == GoalEvent::Kind::Drop) {
      dragged_.clear();
      dropped_.push_back(event.robot);
    }
  }
  return events;
}

void GoalMarkers::onFeedback(const Feedback& feedback, const std::string& robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const sylph::Point point{feedback->pose.position.x, feedback->pose.position.y};
  switch (feedback->event_type) {
    case InteractiveMarkerFeedback::BUTTON_CLICK:
      events_.push_back({GoalEvent::Kind::Select, robot, point});
      break;
    case InteractiveMarkerFeedback::MOUSE_DOWN:
      held_ = robot;
      held_at_ = point;
      events_.push_back({GoalEvent::Kind::Select, robot, point});
      break;
    case InteractiveMarkerFeedback::POSE_UPDATE:
      if (robot == held_) {
        held_at_ = point;
        events_.push_back({GoalEvent::Kind::Drag, robot, point});
      }
      break;
    case InteractiveMarkerFeedback::MOUSE_UP:
      // Let go above another handle, RViz tells it of that one.
      if (!held_.empty()) {
        events_.push_back({GoalEvent::Kind::Drop, held_, robot == held_ ? point : held_at_});
        held_.clear();
      }
      break;
    default:
      break;
  }
}

void GoalMarkers::showRobot(const GoalHandle& handle) {
  // RViz may pick either of two that lie on each other, whichever is higher.
  if (handle.is_on_robot) {
    server_.erase(kRobot + handle.robot);
    return;
  }
  const Marker shape = box({}, {0.0, 0.0}, handle.length_m, handle.width_m, kRobotPickedM,
                           withAlpha(white(), kPickedAlpha));
  server_.insert(
      makeInteractive(kRobot + handle.robot, handle.robot, InteractiveMarkerControl::BUTTON, shape),
      [this, robot = handle.robot](const Feedback& feedback) {
        if (feedback->event_type == InteractiveMarkerFeedback::BUTTON_CLICK) {
          onFeedback(feedback, robot);
        }
      });
}

void GoalMarkers::showGoal(const GoalHandle& handle, double cell_size_m) {
  const std::string name = kGoal + handle.robot;
  const double radius_m = 0.48 * cell_size_m;
  if (!handle.goal) {
    server_.erase(name);
    return;
  }
  const auto before = shown_.find(handle.robot);
  if (before != shown_.end() && before->second.goal) {
    server_.setPose(name, poseAt(*handle.goal));
    return;
  }
  InteractiveMarker marker = makeInteractive(
      name, sylph_ros::kMapFrame, InteractiveMarkerControl::MOVE_PLANE,
      disc({}, {0.0, 0.0}, radius_m, kGoalPickedM, withAlpha(white(), kPickedAlpha)));
  marker.controls[0].markers.push_back(
      disc({}, {0.0, 0.0}, radius_m, height::kGoal, withAlpha(handle.color, 0.25)));
  marker.controls[0].markers.back().header = std_msgs::Header();
  marker.pose = poseAt(*handle.goal);
  server_.insert(marker, [this, robot = handle.robot](const Feedback& feedback) {
    onFeedback(feedback, robot);
  });
}

void GoalMarkers::show(const std::vector<GoalHandle>& handles, double cell_size_m) {
  bool has_changed = false;
  for (const GoalHandle& handle : handles) {
    const auto before = shown_.find(handle.robot);
    const bool is_new = before == shown_.end();
    const bool is_dropped =
        std::find(dropped_.begin(), dropped_.end(), handle.robot) != dropped_.end();
    const bool is_changed = is_new || before->second.is_on_robot != handle.is_on_robot;
    const bool moves = is_changed || is_dropped || !isSame(before->second.goal, handle.goal);
    if (moves && handle.robot != dragged_) {
      if (is_changed) {
        showRobot(handle);
      }
      showGoal(handle, cell_size_m);
      shown_[handle.robot] = handle;
      has_changed = true;
    }
  }
  dropped_.clear();
  if (has_changed) {
    server_.applyChanges();
  }
}

}  // namespace sylph_rviz
