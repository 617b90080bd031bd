// How a plan begins: when it comes, and when the event log brings it back.
#include <algorithm>
#include <stdexcept>

#include "sylph_core/adg/execution.hpp"

namespace sylph {
namespace {

/// A cell outside every map, for a robot that takes no part and stands where it stands.
Cell nowhere(int robot) {
  return {-1 - robot, -1};
}

}  // namespace

bool Execution::isNew(std::uint32_t plan_id) const {
  // After a restart a plan may be pending of which only the id is known.
  return plan_id > plan_id_ || (plan_id == plan_id_ && phase_ == ExecutionPhase::Pending &&
                                admission_.pending() == nullptr);
}

void Execution::refuse(std::uint32_t plan_id, const std::string& reason) {
  if (isNew(plan_id)) {
    setRefused(plan_id, reason);
  }
}

void Execution::setRefused(std::uint32_t plan_id, const std::string& reason) {
  admission_.withdraw();
  plan_id_ = plan_id;
  last_plan_id_ = std::max(last_plan_id_, plan_id);
  refusal_ = "plan " + std::to_string(plan_id) + ": " + reason;
  phase_ = ExecutionPhase::Refused;
  log(event::Refused{refusal_});
}

bool Execution::leadsALostRobot(const MissionPlan& plan) const {
  return plan.replaces_plan_id != 0 &&
         // A new mission may lead it again, which is how a robot comes back.
         std::any_of(plan.robots.begin(), plan.robots.end(), [this](const std::string& name) {
           const std::optional<int> robot = indexOf(name);
           return robot && monitors_[index(*robot)].isLost();
         });
}

void Execution::submit(MissionPlan plan, double now_s) {
  const std::uint32_t plan_id = plan.plan_id;
  if (!isNew(plan_id)) {
    return;
  }
  if (leadsALostRobot(plan)) {
    return;  // it was made before the robot was lost: the others wait for one without it
  }
  // A robot knows such an id from an earlier run, and its reports would count for this plan.
  if (plan_id > plan_id_ && plan_id <= last_plan_id_) {
    setRefused(plan_id, "its id is not greater than " + std::to_string(last_plan_id_) +
                            ", which is the last one in use");
    return;
  }
  if (plan.replaces_plan_id == 0) {
    makeRoomFor(plan_id);
  }
  // A replacement leaves the cut plan in place until it starts: if it is refused, the robots still
  // rest at the cut.
  if (const auto fault = admission_.propose(std::move(plan), present(), now_s)) {
    setRefused(plan_id, *fault);
    return;
  }
  tryStart(now_s);
  advance();
}

void Execution::makeRoomFor(std::uint32_t plan_id) {
  admission_.withdraw();
  refusal_.clear();
  plan_id_ = plan_id;
  last_plan_id_ = plan_id;
  if (graph_ && !is_abandoned_) {
    is_abandoned_ = true;
    logOfPlan(event::Abandoned{});
  }
  setPhase(ExecutionPhase::Pending);
}

bool Execution::tryStart(double now_s) {
  using Verdict = PlanAdmission::Decision::Verdict;
  wait_reason_.clear();
  if (admission_.pending() != nullptr && leadsALostRobot(*admission_.pending())) {
    admission_.withdraw();
  }
  if (admission_.pending() == nullptr) {
    aligned_.reset();
    return false;
  }
  const std::uint32_t plan_id = admission_.pending()->plan_id;
  const PlanAdmission::Decision decision = admission_.decide(present(), now_s);
  align(decision, now_s);
  const bool is_decided = decision.verdict != Verdict::Wait && decision.verdict != Verdict::Align;
  if (!is_decided) {
    wait_reason_ = decision.reason;
  } else if (decision.verdict == Verdict::Refuse) {
    setRefused(plan_id, decision.reason);
  } else if (decision.verdict == Verdict::Start) {
    try {
      load(admission_.takePending());
    } catch (const PlanRefused& refused) {
      setRefused(plan_id, refused.what());
    }
  }
  return is_decided;
}

void Execution::align(const PlanAdmission::Decision& decision, double now_s) {
  if (decision.verdict != PlanAdmission::Decision::Verdict::Align || mode_ != ExecutionMode::Run) {
    aligned_.reset();
  } else if (aligned_ != decision.robot) {
    aligned_ = decision.robot;
    admission_.waitAnew(now_s);
  }
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
  for (Delivery& delivery : deliveries_) {
    delivery = {delivery.first_sequence, 0, {}, {}};
  }
  agents_.clear();
  for (std::size_t agent = 0; agent < plan_->robots.size(); ++agent) {
    agents_.emplace(indexOf(plan_->robots[agent]).value(), static_cast<AgentId>(agent));
  }
  log(event::Started{plan_});
  setPhase(ExecutionPhase::Executing);
}

void Execution::loadMission(const MissionPlan& plan) {
  // The graph knows all robots of the lab by one index, whoever takes part: a later plan, and a
  // lost robot, then need no second numbering. Who takes no part gets no task.
  Configuration standing;
  for (int robot = 0; robot < robotCount(); ++robot) {
    standing.push_back(nowhere(robot));
  }
  std::vector<int> members;
  for (const std::string& name : plan.robots) {
    members.push_back(indexOf(name).value());
  }
  Plan whole(plan.plan.size(), standing);
  for (std::size_t t = 0; t < whole.size(); ++t) {
    for (std::size_t agent = 0; agent < members.size(); ++agent) {
      whole[t][index(members[agent])] = plan.plan[t].at(agent);
    }
  }
  graph_.emplace(ActionDependencyGraph(whole, names_));
  mission_goals_.clear();
  for (std::size_t agent = 0; agent < members.size(); ++agent) {
    const int robot = members[agent];
    mission_goals_[robot] = plan.goals.at(agent);
    monitors_[index(robot)].rejoin();
  }
  for (Delivery& delivery : deliveries_) {
    delivery.first_sequence = 0;
  }
}

void Execution::loadReplacement(const MissionPlan& plan) {
  if (!graph_) {
    throw std::invalid_argument("there is no plan to replace");
  }
  CommitCut cut;
  for (int robot = 0; robot < robotCount(); ++robot) {
    // At the cut all that was released is done, save by lost robots, which hold what they had.
    cut.push_back(graph_->releasedCount(robot));
  }
  std::vector<AgentId> agents;
  for (const std::string& robot : plan.robots) {
    agents.push_back(indexOf(robot).value());
  }
  graph_->replaceRest(cut, agents, plan.plan);
  for (int robot = 0; robot < robotCount(); ++robot) {
    deliveries_[index(robot)].first_sequence = cut[index(robot)];
  }
}

/// What each event leaves behind.
struct Execution::Replay {
  Execution& execution;
  std::uint32_t plan_id;

  void operator()(const event::Started& started) const { execution.load(started.plan); }
  void operator()(const event::Refused& refused) const {
    execution.plan_id_ = plan_id;
    execution.refusal_ = refused.reason;
    execution.phase_ = ExecutionPhase::Refused;
  }
  void operator()(const event::Abandoned& /*abandoned*/) const { execution.is_abandoned_ = true; }
  void operator()(const event::Released& released) const {
    const TaskId task = execution.taskOf(released.robot, released.sequence);
    execution.graph_->enqueue(task);
    execution.undelivered_.insert(released.robot);
  }
  void operator()(const event::Done& done) const {
    const TaskId task = execution.taskOf(done.robot, done.sequence);
    execution.graph_->complete(task);
  }
  void operator()(const event::Lost& lost) const {
    execution.monitors_.at(index(lost.robot)).setLost();
  }
  void operator()(const event::Mode& mode) const {
    execution.mode_ = mode.mode;
    execution.mode_reason_ = mode.mode == ExecutionMode::Run ? std::string() : mode.reason;
  }
  void operator()(const event::Phase& phase) const {
    execution.plan_id_ = plan_id;
    execution.phase_ = phase.phase;
    execution.is_cut_ = execution.is_cut_ || phase.phase == ExecutionPhase::Cutting;
  }
  // Robots tell these themselves.
  void operator()(const event::Accepted& /*accepted*/) const {}
  void operator()(const event::Condition& /*condition*/) const {}
};

void Execution::replay(const ExecutionEvent& event) {
  last_plan_id_ = std::max(last_plan_id_, event.plan_id);
  std::visit(Replay{*this, event.plan_id}, event.what);
  events_.clear();
}

}  // namespace sylph
