#include "sylph_core/control/motion_watch.hpp"

#include <cstdio>
#include <stdexcept>

#include "sylph_core/geometry/segment.hpp"

namespace sylph {
namespace {

/// Until the speed has come down to creeping.
constexpr double kSettling_s = 0.5;
/// Share of the creeping after which an answer counts: long against the noise of a pose.
constexpr double kTelling = 0.4;

Point tip(const Vector2& v) {
  return {v.x, v.y};
}

}  // namespace

MotionWatch::MotionWatch(const MotionWatchOptions& options) : options_(options) {
  const bool is_valid = options.window_s > 0.0 && options.aside_m > 0.0 &&
                        options.least_answer >= 0.0 && options.least_answer <= 1.0 &&
                        options.patience_m > 0.0 && options.creep_mps > 0.0 &&
                        options.creep_m > 0.0;
  if (!is_valid) {
    throw std::invalid_argument("motion watch: every option must be > 0, the share at most 1");
  }
}

void MotionWatch::Stretch::add(const Stretch& other, double sign) {
  commanded = commanded + sign * other.commanded;
  measured = measured + sign * other.measured;
  duration_s += sign * other.duration_s;
}

void MotionWatch::offer(const Vector2& commanded, const Vector2& measured, double duration_s) {
  const Stretch stretch{commanded, measured, duration_s};
  stretches_.push_back(stretch);
  window_.add(stretch, 1.0);
  while (window_.duration_s > options_.window_s && stretches_.size() > 1) {
    window_.add(stretches_.front(), -1.0);
    stretches_.pop_front();
  }
  // Short of where it was driven is a base that slips or is stuck; aside of the way there is none
  // that a command explains.
  const double aside_m = distanceToSegment(tip(window_.measured), {}, tip(window_.commanded));
  if (aside_m > options_.aside_m && !problem_) {
    char text[160];
    std::snprintf(text, sizeof(text),
                  "its pose moves otherwise than it is driven (%.0f mm in %.1f s): are bodies "
                  "exchanged or turned?",
                  aside_m * 1e3, options_.window_s);
    problem_ = text;
  }
  if (is_unanswered_) {
    creep(stretch);
  } else {
    listen(stretch);
  }
}

bool MotionWatch::isAnswered(const Stretch& stretch) const {
  return dot(stretch.commanded, stretch.measured) >=
         options_.least_answer * dot(stretch.commanded, stretch.commanded);
}

void MotionWatch::listen(const Stretch& stretch) {
  // Less is within the noise of a pose, and says nothing.
  if (norm(window_.commanded) > options_.aside_m) {
    unanswered_m_ = isAnswered(window_) ? 0.0 : unanswered_m_ + norm(stretch.commanded);
  }
  if (unanswered_m_ > options_.patience_m) {
    is_unanswered_ = true;
    crept_ = {};
    creeping_s_ = 0.0;
  }
}

void MotionWatch::creep(const Stretch& stretch) {
  creeping_s_ += stretch.duration_s;
  // What it still moves by the commands from before creeping is no answer.
  if (creeping_s_ < kSettling_s) {
    return;
  }
  crept_.add(stretch, 1.0);
  const double commanded_m = norm(crept_.commanded);
  if (commanded_m >= kTelling * options_.creep_m && isAnswered(crept_)) {
    is_unanswered_ = false;
    unanswered_m_ = 0.0;
  } else if (commanded_m >= options_.creep_m && !problem_) {
    problem_ = "its pose does not follow the commands: is its base dead, or are bodies exchanged?";
  }
}

void MotionWatch::pause() {
  stretches_.clear();
  window_ = {};
  unanswered_m_ = 0.0;
}

void MotionWatch::confirm() {
  pause();
  is_unanswered_ = false;
  problem_.reset();
}

}  // namespace sylph
