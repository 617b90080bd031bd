#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/execution/states.hpp"

namespace sylph_adg_central {

/// What the operator is told of robots that are silent, stuck or blind: that it is so, and when it
/// is over how often and how long it was. A condition that comes and goes is told once.
class ConditionLog {
 public:
  /// A condition that has not come again for so long is over [s].
  static constexpr double kSettled_s = 5.0;

  /// @param names  of the robots, by index
  explicit ConditionLog(std::vector<std::string> names) : names_(std::move(names)) {}

  /// A robot's condition has changed.
  /// @param reason  one line, may be empty
  /// @param now_s   never less than in a call before [s]
  /// @return a line to be told now
  std::optional<std::string> note(int robot, sylph::RobotCondition condition,
                                  const std::string& reason, double now_s);
  /// @return a line for each condition of a robot that is over by now
  std::vector<std::string> takeSettled(double now_s);
  /// Nobody looks any more.
  /// @return a line for each condition of a robot that has been told of, and was not over
  std::vector<std::string> takeAll(double now_s);

 private:
  struct Record {
    int times = 0;
    double first_s = 0.0;
    double since_s = 0.0;
    double last_s = 0.0;   ///< until when it was so for the last time
    double total_s = 0.0;  ///< without the present time
    bool is_now = false;
  };
  using Key = std::pair<int, sylph::RobotCondition>;

  std::string summary(const Key& key, const Record& record) const;

  std::vector<std::string> names_;
  std::map<Key, Record> records_;
};

}  // namespace sylph_adg_central
