#include "sylph_core/mission/plan_preview.hpp"

#include <variant>

namespace sylph {

void PlanPreview::ask(Mission mission, double now_s) {
  mission_ = std::move(mission);
  since_s_ = now_s;
  stage_ = Stage::Starting;
  waits_for_.clear();
  answer_.reset();
  withdraw();
}

void PlanPreview::cancel() {
  stage_ = Stage::Idle;
  answer_.reset();
}

std::optional<PlanPreview::PlanningTask> PlanPreview::tick(const RobotPoses& poses,
                                                           bool is_mission_under_way,
                                                           double now_s) {
  if (stage_ != Stage::Starting || is_planning_) {
    return std::nullopt;
  }
  try {
    if (is_mission_under_way) {
      throw MissionFailure(MissionOutcome::BadRequest,
                           "a mission is under way: plan when it has ended, or cancel it");
    }
    return startPlanning(poses, now_s);
  } catch (const MissionFailure& failure) {
    waits_for_ = failure.what();
    if (failure.outcome() != MissionOutcome::NoPose || hasWaitedForPoses(now_s)) {
      answer(failure);
    }
    return std::nullopt;
  }
}

std::optional<PlanPreview::PlanningTask> PlanPreview::startPlanning(const RobotPoses& poses,
                                                                    double now_s) {
  MissionStart start =
      startOf(mission_, lab_, poses, limits_.ignores_unseen_robots && hasWaitedForPoses(now_s),
              limits_.bystander_distance_m);
  stage_ = Stage::Planning;
  is_planning_ = true;
  waits_for_.clear();
  return PlanningTask{[mission = mission_, instance = std::move(start.instance)] {
                        return outcomeOf([&] { return planMission(mission, instance); });
                      },
                      std::move(start.unseen)};
}

void PlanPreview::onPlanned(PlanningOutcome outcome) {
  is_planning_ = false;
  if (stage_ == Stage::Planning) {
    answer(std::move(outcome));
  }
}

void PlanPreview::answer(PlanningOutcome outcome) {
  stage_ = Stage::Idle;
  if (const auto* plan = std::get_if<CheckedPlan>(&outcome)) {
    shown_ = *plan;
    ++number_;
  }
  answer_ = std::move(outcome);
}

CheckedPlan PlanPreview::planOf(std::uint32_t number, const Mission& mission) const {
  if (!shown_ || number != number_) {
    throw MissionFailure(MissionOutcome::BadRequest,
                         "plan " + std::to_string(number) + " is not shown any more: plan again");
  }
  if (mission.robots != mission_.robots || mission.goals != mission_.goals ||
      mission.grid != mission_.grid) {
    throw MissionFailure(
        MissionOutcome::BadRequest,
        "plan " + std::to_string(number) + " is of other robots, goals or map: plan again");
  }
  return *shown_;
}

}  // namespace sylph
