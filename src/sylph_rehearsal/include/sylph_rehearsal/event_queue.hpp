#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace sylph_rehearsal {

/// What happens when, in the order of time; what happens at the same time, in the order in which it
/// was added. So a run depends on nothing but what is put in.
class EventQueue {
 public:
  /// What happens.
  using Action = std::function<void()>;

  /// @param time_s  of the start
  explicit EventQueue(double time_s = 0.0) : now_s_(time_s) {}

  /// @param time_s  when it happens; what is past already happens next
  void at(double time_s, Action action);
  /// @param delay_s  from now until it happens
  void after(double delay_s, Action action) { at(now_s_ + delay_s, std::move(action)); }

  /// The time of the action that happens, or that happened last [s].
  double now() const { return now_s_; }
  /// Lets everything up to a time happen, in order.
  /// @param goes_on  asked after each action; false ends it early
  void run(double until_s, const std::function<bool()>& goes_on);

 private:
  struct Entry {
    double time_s;
    std::uint64_t number;
    Action action;
  };
  struct Later {
    bool operator()(const Entry& a, const Entry& b) const {
      return a.time_s != b.time_s ? a.time_s > b.time_s : a.number > b.number;
    }
  };

  double now_s_;
  std::uint64_t count_ = 0;
  std::vector<Entry> entries_;  // a heap by Later
};

}  // namespace sylph_rehearsal
