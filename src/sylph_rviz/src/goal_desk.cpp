#include "sylph_rviz/goal_desk.hpp"

#include <utility>

#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

constexpr double kLetterM = 0.10;

void addGoal(const Scene& scene, const RobotView& robot, const sylph::Cell& goal,
             Markers& markers) {
  const auto center = centerOf(scene, goal);
  if (!center) {
    return;
  }
  const int id = static_cast<int>(&robot - scene.robots.data());
  const auto color = robotColor(static_cast<std::size_t>(id));
  const double radius_m = 0.4 * scene.map->cell_size_m;
  markers.push_back(disc({"goal", id}, *center, radius_m, height::kGoal, withAlpha(color, 0.8)));
  markers.push_back(ring({"goal_ring", id}, *center, radius_m, height::kWait, 0.02, white()));
  markers.push_back(text({"goal_name", id}, *center, height::kText, 0.12, shortName(robot.name),
                         textColorOn(color)));
  if (robot.pose && sylph::distance(sylph::position(*robot.pose), *center) > 0.01) {
    const sylph::Point from = sylph::position(*robot.pose);
    markers.push_back(lineList({"goal_line", id}, dashes(from, *center, radius_m, 0.04),
                               height::kDriven, 0.02, color));
  }
}

/// A frame round the cell; a cross in it and the reason below it if it is refused.
void addHover(const Scene& scene, const GoalDraft::Proposal& proposal, Markers& markers) {
  constexpr std::size_t kColumns = 30;
  const auto center = centerOf(scene, proposal.cell);
  if (!center) {
    return;
  }
  const bool is_refused = !proposal.refusal.empty();
  const auto color = is_refused ? vermillion() : white();
  const double r = 0.47 * scene.map->cell_size_m;
  const auto at = [&](double x, double y) {
    return sylph::Point{center->x + x * r, center->y + y * r};
  };
  markers.push_back(lineStrip({"hover", 0},
                              {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1), at(-1, -1)},
                              height::kBadge, 0.03, color));
  if (is_refused) {
    markers.push_back(lineList({"hover_cross", 0}, {at(-1, -1), at(1, 1), at(-1, 1), at(1, -1)},
                               height::kBadge, 0.03, color));
    int line = 0;
    for (const std::string& words : wrapped(proposal.refusal, kColumns)) {
      const sylph::Point place{center->x, center->y - r - (line + 1) * 1.2 * kLetterM};
      markers.push_back(text({"hover_text", line}, place, height::kText, kLetterM, words, color));
      ++line;
    }
  }
}

}  // namespace

void GoalDesk::setLab(std::optional<sylph::Experiment> lab) {
  clear();
  draft_.reset();
  if (lab) {
    draft_.emplace(std::move(*lab));
  }
}

void GoalDesk::drag(const std::string& robot, const sylph::Point& point,
                    const sylph::RobotPoses& poses) {
  if (draft_) {
    hover_ = Hover{robot, draft_->propose(robot, point, poses)};
  }
}

std::string GoalDesk::set(const std::string& robot, const sylph::Point& point,
                          const sylph::RobotPoses& poses) {
  hover_.reset();
  const GoalDraft::Proposal proposal = draft_.value().set(robot, point, poses);
  if (!proposal.refusal.empty()) {
    return proposal.refusal;
  }
  return draft_->goals().count(robot) == 0 ? robot + " stays"
                                           : robot + " to " + toString(proposal.cell);
}

void GoalDesk::clear() {
  hover_.reset();
  planned_.reset();
  if (draft_) {
    draft_->clear();
  }
}

void GoalDesk::setOthersGiveWay(bool others_give_way) {
  if (draft_) {
    draft_->setOthersGiveWay(others_give_way);
  }
}

void GoalDesk::onSent() {
  planned_ = Planned{draft_.value().goals(), draft_->othersGiveWay(), std::nullopt};
}

void GoalDesk::onPlanned(const sylph_msgs::ExecuteMissionResult& result) {
  if (planned_) {
    planned_->result = result;
  }
}

bool GoalDesk::isOfPlan() const {
  return planned_ && draft_ && planned_->goals == draft_->goals() &&
         planned_->others_give_way == draft_->othersGiveWay();
}

std::uint32_t GoalDesk::shownPlan() const {
  return isOfPlan() && planned_->result ? planned_->result->shown_plan_id : 0;
}

std::string GoalDesk::text() const {
  if (!draft_ || draft_->goals().empty()) {
    return "";
  }
  std::string text = draft_->headline();
  if (isOfPlan()) {
    text += !planned_->result ? "\nplanning"
            : shownPlan() == 0
                ? "\nno plan: " + planned_->result->message
                : "\nplan " + std::to_string(shownPlan()) + ": " + planned_->result->message;
  }
  return text;
}

Refusal GoalDesk::plan() const {
  if (!draft_) {
    return "the lab's experiment is not known here";
  }
  if (draft_->goals().empty()) {
    return "no goal is set: drag a robot's, or use 2D Nav Goal for the selected robot";
  }
  return isOfPlan() && !planned_->result ? "it is being planned" : "";
}

Refusal GoalDesk::go() const {
  Refusal refusal = plan();
  if (!refusal.empty() || shownPlan() != 0) {
    return refusal;
  }
  return !planned_     ? "plan first"
         : !isOfPlan() ? "the goals have changed: plan again"
                       : "there is no plan: " + planned_->result->message;
}

Markers GoalDesk::markers(const Scene& scene) const {
  Markers markers;
  if (!draft_ || !scene.map) {
    return markers;
  }
  for (const RobotView& robot : scene.robots) {
    const auto goal = draft_->goals().find(robot.name);
    const bool is_dragged = hover_ && hover_->robot == robot.name;
    if (goal != draft_->goals().end() && !is_dragged) {
      addGoal(scene, robot, goal->second, markers);
    }
  }
  if (hover_) {
    addHover(scene, hover_->proposal, markers);
  }
  return markers;
}

}  // namespace sylph_rviz
