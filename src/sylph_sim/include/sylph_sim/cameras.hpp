#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_sim/bounds.hpp"
#include "sylph_sim/fault.hpp"

namespace sylph_sim {

/// How the simulated cameras see. Frames leave in the order of their capture.
struct CameraOptions {
  double rate_hz = 120.0;                  ///< frames a simulated second
  double latency_s = 0.008;                ///< from capture to sending
  double position_noise_m = 0.0002;        ///< standard deviation an axis and frame
  double yaw_noise_rad = 0.001;            ///< standard deviation a frame
  double body_offset_m = 0.001;            ///< standard deviation of a body's constant offset
  double body_yaw_offset_rad = 0.003;      ///< standard deviation of its constant rotation
  double occlusion_probability = 0.0005;   ///< of a body not being tracked in a frame
  double frame_loss_probability = 0.0005;  ///< of a frame never being sent
};

/// Shows each number with its bounds and meaning.
void visitNumbers(CameraOptions& options, const NumberVisitor& visit);

/// @throws std::invalid_argument naming the member, its value and its bound
void requireValid(const CameraOptions& options);

/// One body as the cameras see it, in the map frame.
struct CapturedBody {
  sylph::Pose2d pose;      ///< noise and mounting error included
  bool is_tracked = true;  ///< false: not seen in this frame
};

/// All bodies at one instant.
struct CapturedFrame {
  std::int32_t number = 0;           ///< counts up; a gap tells of a frame that was lost
  double captured_s = 0.0;           ///< simulated time of the exposure [s]
  double sent_s = 0.0;               ///< simulated time at which it left [s], >= captured_s
  std::vector<CapturedBody> bodies;  ///< one a robot
};

/// A motion-capture system without the cameras.
class Cameras {
 public:
  /// @param poses  where the robots are at start_s
  /// @throws std::invalid_argument as requireValid()
  Cameras(const CameraOptions& options, const std::vector<sylph::Pose2d>& poses, double start_s,
          sylph::Rng rng);

  /// Takes every frame whose exposure lies in (time of the last call, time_s].
  /// @param before  poses at the last call, one a robot
  /// @param after   poses at time_s; between the two motion is taken as uniform
  void capture(double time_s, const std::vector<sylph::Pose2d>& before,
               const std::vector<sylph::Pose2d>& after, const FaultState& faults);

  /// Frames that have to leave by `time_s`, oldest first. Each is returned once.
  std::vector<CapturedFrame> takeDue(double time_s);

 private:
  double nextExposure() const { return start_s_ + next_number_ / options_.rate_hz; }
  CapturedBody see(std::size_t robot, const std::vector<sylph::Pose2d>& poses,
                   const CaptureFault& fault);

  CameraOptions options_;
  sylph::Rng rng_;
  double last_s_;
  double start_s_;
  std::int32_t next_number_ = 1;
  std::vector<sylph::Pose2d> robot_from_body_;  // of each robot
  std::vector<sylph::Pose2d> last_seen_;        // what a frozen body keeps showing
  std::deque<CapturedFrame> waiting_;
};

}  // namespace sylph_sim
