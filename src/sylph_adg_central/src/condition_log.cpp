#include "sylph_adg_central/trouble_teller.hpp"

#include <cstdio>

namespace sylph_adg_central {
namespace {

std::string seconds(double value_s) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f s", value_s);
  return text;
}

}  // namespace

std::optional<std::string> TroubleTeller::note(int robot, sylph::RobotCondition condition,
                                               const std::string& reason, double now_s) {
  for (auto& [key, trouble] : troubles_) {
    if (key.first == robot && trouble.is_now && key.second != condition) {
      trouble.is_now = false;
      trouble.last_s = now_s;
      trouble.total_s += now_s - trouble.since_s;
    }
  }
  if (condition == sylph::RobotCondition::Ok) {
    return std::nullopt;
  }
  const auto [entry, is_new] = troubles_.try_emplace({robot, condition});
  Trouble& trouble = entry->second;
  if (trouble.is_now) {
    return std::nullopt;
  }
  ++trouble.times;
  trouble.is_now = true;
  trouble.since_s = now_s;
  if (!is_new) {
    return std::nullopt;
  }
  trouble.first_s = now_s;
  return names_.at(static_cast<std::size_t>(robot)) + " is " + toString(condition) +
         (reason.empty() ? "" : ": " + reason);
}

std::vector<std::string> TroubleTeller::takeSettled(double now_s) {
  std::vector<std::string> lines;
  for (auto entry = troubles_.begin(); entry != troubles_.end();) {
    const Trouble& trouble = entry->second;
    if (trouble.is_now || now_s - trouble.last_s < kSettled_s) {
      ++entry;
    } else {
      lines.push_back(summary(entry->first, trouble));
      entry = troubles_.erase(entry);
    }
  }
  return lines;
}

std::vector<std::string> TroubleTeller::takeAll(double now_s) {
  std::vector<std::string> lines;
  for (auto& [key, trouble] : troubles_) {
    if (trouble.is_now) {
      trouble.last_s = now_s;
      trouble.total_s += now_s - trouble.since_s;
    }
    lines.push_back(summary(key, trouble));
  }
  troubles_.clear();
  return lines;
}

std::string TroubleTeller::summary(const Key& key, const Trouble& trouble) const {
  const std::string was = names_.at(static_cast<std::size_t>(key.first)) +
                          (trouble.is_now ? " has been " : " was ") + toString(key.second);
  if (trouble.times == 1) {
    return was + " for " + seconds(trouble.total_s);
  }
  return was + " " + std::to_string(trouble.times) + " times within " +
         seconds(trouble.last_s - trouble.first_s) + ", " + seconds(trouble.total_s) + " in all";
}

}  // namespace sylph_adg_central
