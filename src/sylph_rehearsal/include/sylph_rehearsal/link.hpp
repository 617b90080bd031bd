#pragma once

#include "sylph_core/grid/rng.hpp"
#include "sylph_rehearsal/event_queue.hpp"

namespace sylph_rehearsal {

/// How messages travel on a link. Probabilities count for each message by itself.
struct LinkOptions {
  double delay_s = 0.001;   ///< >= 0
  double jitter_s = 0.001;  ///< added to it, uniform in 0 ... jitter_s, >= 0
  double loss = 0.0;        ///< of never arriving, 0 ... 1
  double doubling = 0.0;    ///< of arriving a second time, 0 ... 1
  double reordering = 0.0;  ///< of being held up while later ones pass, 0 ... 1
  double held_up_s = 0.2;   ///< for up to so long, >= 0
};

/// One way between two nodes. Messages keep their order unless one is held up.
class Link {
 public:
  /// @param queue  has to outlive the link
  Link(EventQueue& queue, const LinkOptions& options, const sylph::Rng& rng)
      : queue_(&queue), options_(options), rng_(rng) {}

  /// @param arrival  what happens when the message arrives, each time it does
  void send(const EventQueue::Action& arrival);

  /// Counts for messages sent from now on.
  void setOptions(const LinkOptions& options) { options_ = options; }
  /// In force at present.
  const LinkOptions& options() const { return options_; }

 private:
  bool draw(double probability) {
    return probability > 0.0 && sylph::drawFraction(rng_) < probability;
  }

  EventQueue* queue_;
  LinkOptions options_;
  sylph::Rng rng_;
  double last_s_ = 0.0;  // when the last message in order arrives
};

}  // namespace sylph_rehearsal
