#include "sylph_adg_central/condition_log.hpp"

#include "sylph_core/text/format.hpp"

namespace sylph_adg_central {

std::optional<std::string> ConditionLog::note(int robot, sylph::RobotCondition condition,
                                              const std::string& reason, double now_s) {
  for (auto& [key, record] : records_) {
    if (key.first == robot && record.is_now && key.second != condition) {
      record.is_now = false;
      record.last_s = now_s;
      record.total_s += now_s - record.since_s;
    }
  }
  if (condition == sylph::RobotCondition::Ok) {
    return std::nullopt;
  }
  const auto [entry, is_new] = records_.try_emplace({robot, condition});
  Record& record = entry->second;
  if (record.is_now) {
    return std::nullopt;
  }
  ++record.times;
  record.is_now = true;
  record.since_s = now_s;
  // Told once; how often and how long follows when it has settled. A robot with a bad radio would
  // fill the terminal.
  if (!is_new) {
    return std::nullopt;
  }
  record.first_s = now_s;
  return names_.at(static_cast<std::size_t>(robot)) + " is " + toString(condition) +
         (reason.empty() ? "" : ": " + reason);
}

std::vector<std::string> ConditionLog::takeSettled(double now_s) {
  std::vector<std::string> lines;
  for (auto entry = records_.begin(); entry != records_.end();) {
    const Record& record = entry->second;
    if (record.is_now || now_s - record.last_s < kSettled_s) {
      ++entry;
    } else {
      lines.push_back(summary(entry->first, record));
      entry = records_.erase(entry);
    }
  }
  return lines;
}

std::vector<std::string> ConditionLog::takeAll(double now_s) {
  std::vector<std::string> lines;
  for (auto& [key, record] : records_) {
    if (record.is_now) {
      record.last_s = now_s;
      record.total_s += now_s - record.since_s;
    }
    lines.push_back(summary(key, record));
  }
  records_.clear();
  return lines;
}

std::string ConditionLog::summary(const Key& key, const Record& record) const {
  const std::string was = names_.at(static_cast<std::size_t>(key.first)) +
                          (record.is_now ? " has been " : " was ") + toString(key.second);
  if (record.times == 1) {
    return was + " for " + sylph::format("%.1f s", record.total_s);
  }
  return was + " " + std::to_string(record.times) + " times within " +
         sylph::format("%.1f s", record.last_s - record.first_s) + ", " +
         sylph::format("%.1f s", record.total_s) + " in all";
}

}  // namespace sylph_adg_central
