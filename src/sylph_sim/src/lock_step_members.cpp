#include "sylph_sim/lock_step_members.hpp"

#include <algorithm>

namespace sylph_sim {

void LockStepMembers::call(Stage stage, std::uint32_t number, double wall_s) {
  stage_ = stage;
  number_ = number;
  called_s_ = wall_s;
}

LockStepMembers::Return LockStepMembers::note(const Answer& answer, double wall_s) {
  const auto [entry, is_new] = members_.try_emplace(answer.node);
  Member& member = entry->second;
  Return result;
  result.is_new = is_new || member.is_silent;
  result.silent_s = member.is_silent ? wall_s - member.heard_s : 0.0;
  member.stage = answer.stage;
  member.is_silent = false;
  member.heard_s = wall_s;
  if (!answer.is_busy) {
    member.number = answer.number;
    member.is_ready = answer.is_ready;
  }
  return result;
}

bool LockStepMembers::isAwaited(const Member& member) const {
  return member.stage == stage_ && member.number != number_ && !member.is_silent;
}

bool LockStepMembers::hasAnswered() const {
  return std::none_of(members_.begin(), members_.end(),
                      [this](const auto& entry) { return isAwaited(entry.second); });
}

std::vector<std::string> LockStepMembers::unready() const {
  std::vector<std::string> names;
  for (const std::string& name : expected_) {
    if (members_.count(name) == 0) {
      names.push_back(name);
    }
  }
  for (const auto& [name, member] : members_) {
    if (!member.is_ready) {
      names.push_back(name);
    }
  }
  return names;
}

std::vector<std::string> LockStepMembers::findSilent(double wall_s) {
  std::vector<std::string> names;
  for (auto& [name, member] : members_) {
    if (isAwaited(member) && wall_s - std::max(member.heard_s, called_s_) > limit_s_) {
      member.is_silent = true;
      names.push_back(name);
    }
  }
  return names;
}

std::vector<std::string> LockStepMembers::silent() const {
  std::vector<std::string> names;
  for (const auto& [name, member] : members_) {
    if (member.is_silent) {
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace sylph_sim
