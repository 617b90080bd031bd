#include "sylph_rehearsal/event_queue.hpp"

#include <algorithm>
#include <utility>

namespace sylph_rehearsal {

void EventQueue::at(double time_s, Action action) {
  entries_.push_back({std::max(time_s, now_s_), count_++, std::move(action)});
  std::push_heap(entries_.begin(), entries_.end(), Later());
}

void EventQueue::run(double until_s, const std::function<bool()>& goes_on) {
  while (!entries_.empty() && entries_.front().time_s <= until_s) {
    std::pop_heap(entries_.begin(), entries_.end(), Later());
    const Entry next = std::move(entries_.back());
    entries_.pop_back();
    now_s_ = next.time_s;
    next.action();
    if (!goes_on()) {
      return;
    }
  }
}

}  // namespace sylph_rehearsal
