#include "sylph_sim/cameras.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sylph_sim {
namespace {

/// Cameras that see everything exactly, at 100 Hz, 20 ms late.
CameraOptions idealCameras() {
  CameraOptions options;
  options.rate_hz = 100.0;
  options.latency_s = 0.02;
  options.position_noise_m = 0.0;
  options.yaw_noise_rad = 0.0;
  options.body_offset_m = 0.0;
  options.body_yaw_offset_rad = 0.0;
  options.occlusion_probability = 0.0;
  options.frame_loss_probability = 0.0;
  return options;
}

const std::vector<sylph::Pose2d> kBefore{{1.0, 2.0, 0.1}, {3.0, 4.0, -3.1}};
const std::vector<sylph::Pose2d> kAfter{{1.2, 2.0, 0.3}, {3.0, 4.4, 3.1}};

/// The frame of an exposure half way from kBefore to kAfter.
CapturedFrame halfWay(const CameraOptions& options, const FaultState& faults) {
  Cameras cameras(options, kBefore, 5.0, sylph::Rng(1));
  cameras.capture(5.005, kBefore, kBefore, faults);
  cameras.capture(5.015, kBefore, kAfter, faults);
  const std::vector<CapturedFrame> frames = cameras.takeDue(6.0);
  EXPECT_EQ(1U, frames.size());
  return frames.empty() ? CapturedFrame{} : frames.front();
}

FaultState noFault() {
  return FaultScript(2).stateAt(0.0);
}

TEST(CamerasTest, SeesRobotsWhereTheyAreAtTheExposure) {
  const CapturedFrame frame = halfWay(idealCameras(), noFault());
  EXPECT_NEAR(5.01, frame.captured_s, 1e-9);
  EXPECT_EQ(6.0, frame.sent_s);
  ASSERT_EQ(2U, frame.bodies.size());
  EXPECT_NEAR(1.1, frame.bodies[0].pose.x_m, 1e-6);
  EXPECT_NEAR(0.2, frame.bodies[0].pose.yaw_rad, 1e-6);
  EXPECT_NEAR(4.2, frame.bodies[1].pose.y_m, 1e-6);
  EXPECT_NEAR(M_PI, std::abs(frame.bodies[1].pose.yaw_rad), 1e-6);  // the short way round
  EXPECT_TRUE(frame.bodies[0].is_tracked);
}

TEST(CamerasTest, TakesFramesAtItsRateAndSendsEachOnceAfterItsLatency) {
  Cameras cameras(idealCameras(), kBefore, 0.0, sylph::Rng(1));
  std::int32_t sent = 0;
  for (int step = 1; step <= 200; ++step) {
    const double time_s = step * 0.005;
    cameras.capture(time_s, kBefore, kBefore, noFault());
    for (const CapturedFrame& frame : cameras.takeDue(time_s)) {
      EXPECT_EQ(++sent, frame.number);
      EXPECT_LE(frame.captured_s + 0.02, time_s + 1e-12);
    }
  }
  EXPECT_NEAR(98, sent, 1);  // 100 exposures, the last two still on their way
}

TEST(CamerasTest, ALostFrameIsAGapInTheNumbers) {
  CameraOptions options = idealCameras();
  options.frame_loss_probability = 0.5;
  Cameras cameras(options, kBefore, 0.0, sylph::Rng(1));
  cameras.capture(10.0, kBefore, kBefore, noFault());
  const std::vector<CapturedFrame> frames = cameras.takeDue(20.0);
  EXPECT_NEAR(500, static_cast<double>(frames.size()), 75);
  EXPECT_GT(frames.back().number, 950);
}

TEST(CamerasTest, OcclusionHitsItsShareOfFrames) {
  CameraOptions options = idealCameras();
  options.occlusion_probability = 0.1;
  Cameras cameras(options, kBefore, 0.0, sylph::Rng(1));
  cameras.capture(20.0, kBefore, kBefore, noFault());
  int occluded = 0;
  for (const CapturedFrame& frame : cameras.takeDue(21.0)) {
    occluded += frame.bodies[0].is_tracked ? 0 : 1;
  }
  EXPECT_NEAR(200, occluded, 60);
}

TEST(CamerasTest, NoiseHasItsStandardDeviation) {
  CameraOptions options = idealCameras();
  options.position_noise_m = 0.001;
  Cameras cameras(options, kBefore, 0.0, sylph::Rng(1));
  cameras.capture(20.0, kBefore, kBefore, noFault());
  double sum_of_squares = 0.0;
  const std::vector<CapturedFrame> frames = cameras.takeDue(21.0);
  for (const CapturedFrame& frame : frames) {
    sum_of_squares += std::pow(frame.bodies[0].pose.x_m - kBefore[0].x_m, 2);
  }
  EXPECT_NEAR(0.001, std::sqrt(sum_of_squares / static_cast<double>(frames.size())), 1e-4);
}

TEST(CamerasTest, FaultsDoWhatTheySay) {
  FaultState faults = noFault();
  faults.robots[0].capture.is_lost = true;
  EXPECT_FALSE(halfWay(idealCameras(), faults).bodies[0].is_tracked);

  faults = noFault();
  faults.robots[0].capture.is_nan = true;
  EXPECT_TRUE(std::isnan(halfWay(idealCameras(), faults).bodies[0].pose.x_m));
  EXPECT_TRUE(halfWay(idealCameras(), faults).bodies[0].is_tracked);

  faults = noFault();
  faults.robots[0].capture.is_frozen = true;
  EXPECT_NEAR(1.0, halfWay(idealCameras(), faults).bodies[0].pose.x_m, 1e-9);

  faults = noFault();
  faults.robots[0].capture.yaw_offset_rad = M_PI;
  EXPECT_NEAR(0.2 - M_PI, halfWay(idealCameras(), faults).bodies[0].pose.yaw_rad, 1e-6);

  faults = noFault();
  faults.robots[0].capture.x_offset_m = 0.1;
  EXPECT_NEAR(1.2, halfWay(idealCameras(), faults).bodies[0].pose.x_m, 1e-6);

  faults = noFault();
  faults.robots[0].capture.shown_robot = 1;
  faults.robots[1].capture.shown_robot = 0;
  EXPECT_NEAR(3.0, halfWay(idealCameras(), faults).bodies[0].pose.x_m, 1e-6);
  EXPECT_NEAR(1.1, halfWay(idealCameras(), faults).bodies[1].pose.x_m, 1e-6);
}

TEST(CamerasTest, NothingLeavesSilentCameras) {
  FaultState faults = noFault();
  faults.is_silent = true;
  Cameras cameras(idealCameras(), kBefore, 0.0, sylph::Rng(1));
  cameras.capture(1.0, kBefore, kBefore, faults);
  EXPECT_TRUE(cameras.takeDue(2.0).empty());
}

TEST(CamerasTest, RefusesOptionsOutOfTheirBounds) {
  CameraOptions options;
  options.rate_hz = 0.0;
  EXPECT_THROW(requireValid(options), std::invalid_argument);
  options = {};
  options.occlusion_probability = 1.1;
  EXPECT_THROW(requireValid(options), std::invalid_argument);
  options = {};
  options.latency_s = -0.001;
  EXPECT_THROW(requireValid(options), std::invalid_argument);
}

}  // namespace
}  // namespace sylph_sim
