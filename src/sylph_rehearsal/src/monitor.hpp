#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sylph_core/control/separation.hpp"
#include "sylph_rehearsal/event_queue.hpp"

namespace sylph_rehearsal {

/// The separation monitor.
class Monitor {
 public:
  /// Whether all robots have to stop, and why.
  using StopPort = std::function<void(bool, const std::string&)>;

  /// @param queue  has to outlive it
  Monitor(const std::vector<sylph::Footprint>& sizes, const sylph::SeparationLimits& limits,
          std::vector<std::string> names, EventQueue& queue, StopPort stop);

  /// Tells that nothing is wrong, and from then on what is, again and again.
  void start();
  void onPose(int robot, const sylph::Pose2d& pose, double stamp_s);
  /// @return whether the stop is over: not while robots are too close
  bool reset();

  /// Whether robots have to stop, to all.
  void tell() { stop_(has_tripped_, reason_); }

  bool hasTripped() const { return has_tripped_; }
  const sylph::PairGap& closestEver() const { return watch_.closestEver(); }

 private:
  void tick();

  sylph::SeparationWatch watch_;
  double limit_m_;
  std::vector<std::string> names_;
  EventQueue* queue_;
  StopPort stop_;
  bool has_tripped_ = false;
  std::string reason_;
};

}  // namespace sylph_rehearsal
