#pragma once

#include <atomic>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sylph_mocap_bridge/body_names.hpp"
#include "sylph_mocap_bridge/frame_stamper.hpp"
#include "sylph_mocap_bridge/measurement_input.hpp"
#include "sylph_natnet/client.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_mocap_bridge {

/// Measurements from OptiTrack's stream, received in a thread of its own.
class NatnetInput : public MeasurementInput {
 public:
  /// @param rigid_bodies    name of each robot's rigid body
  /// @param simulated_time  ROS time is not this computer's: it moves in steps, and echoes
  /// (measured
  ///                        by the computer's clock) say nothing about it
  /// @param clock           must outlive the input. In lock step there is no thread: frames are
  ///                        taken when the simulator has sent them
  /// @param sink            must outlive the input
  /// @throws std::runtime_error if a socket cannot be had
  NatnetInput(const sylph_natnet::ClientOptions& client, StampPolicy stamp,
              std::vector<std::string> rigid_bodies, bool simulated_time,
              const sylph_ros::SteadyClock& clock, MeasurementSink& sink);
  ~NatnetInput() override;
  NatnetInput(const NatnetInput&) = delete;
  NatnetInput& operator=(const NatnetInput&) = delete;

  Finding look(diagnostic_updater::DiagnosticStatusWrapper& report) override;

 private:
  /// What the receiving thread leaves for look().
  struct Status {
    LinkStatus link;
    std::optional<sylph_natnet::ClockEstimate> clock;
    double newest_s = 0.0;  ///< server's clock
    std::uint64_t used_frames = 0;
  };

  void receive();
  void joinLockStep(sylph_ros::LockStep& lock_step);
  /// Waits for the frames of a tick. Those of later ticks, which a node that stood still finds, are
  /// held: taken now, they would seem to come before they were sent, and so shift all stamps.
  void takeFramesUpTo(std::int32_t number);
  void handleHeldUpTo(std::int32_t number);
  void onFrame(const sylph_natnet::ReceivedFrame& received);
  void followServer();
  std::vector<Measurement> measurementsOf(const sylph_natnet::Frame& frame, double time_s,
                                          double stamp_s) const;
  void shareStatus();
  /// Offset from the server's clock to ROS time.
  std::optional<sylph_natnet::ClockEstimate> echoOffset(double now_s) const;

  sylph_natnet::ClientOptions options_;
  bool simulated_time_;
  const sylph_ros::SteadyClock& clock_;
  MeasurementSink& sink_;

  // Of the receiving thread alone.
  sylph_natnet::Client client_;
  BodyNames names_;
  FrameStamper stamper_;
  std::uint64_t session_ = 0;
  std::uint64_t definitions_revision_ = 0;
  double last_now_s_ = 0.0;
  std::int32_t last_number_ = 0;                  ///< of the frames that have come
  std::deque<sylph_natnet::ReceivedFrame> held_;  ///< come, but of ticks that are still to be taken
  Status own_status_;
  std::chrono::steady_clock::time_point last_shared_;

  std::mutex mutex_;
  Status shared_status_;  ///< guarded by mutex_

  // Of look() alone.
  Status seen_status_;

  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace sylph_mocap_bridge
