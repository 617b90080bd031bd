#include "sylph_rehearsal/link.hpp"

#include <algorithm>

namespace sylph_rehearsal {

void Link::send(const EventQueue::Action& arrival) {
  if (draw(options_.loss)) {
    return;
  }
  const double delay_s = options_.delay_s + options_.jitter_s * sylph::drawFraction(rng_);
  if (draw(options_.reordering)) {
    queue_->after(delay_s + options_.held_up_s * sylph::drawFraction(rng_), arrival);
  } else {
    last_s_ = std::max(last_s_, queue_->now() + delay_s);
    queue_->at(last_s_, arrival);
  }
  if (draw(options_.doubling)) {
    queue_->after(delay_s + options_.held_up_s * sylph::drawFraction(rng_), arrival);
  }
}

}  // namespace sylph_rehearsal
