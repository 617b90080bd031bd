#include "sylph_mocap_bridge/natnet_input.hpp"

#include <ros/console.h>
#include <ros/time.h>

#include <algorithm>
#include <utility>

#include "sylph_core/text/join.hpp"

namespace sylph_mocap_bridge {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using sylph_natnet::toString;

constexpr milliseconds kPollTimeout{50};
constexpr milliseconds kStatusPeriod{200};

/// A frame that the simulator has sent and that does not come for so long has been lost.
constexpr milliseconds kLockStepPatience{200};

/// In lock step time moves in steps too, but a frame is never taken before it was sent.
ClockSyncOptions clockOptions(bool simulated_time, bool lock_step) {
  ClockSyncOptions options;
  options.quantile = simulated_time && !lock_step ? 0.5 : 0.0;
  return options;
}

/// While a planner is at work, no frames come; neither end may lose patience.
sylph_natnet::ClientOptions clientOptions(sylph_natnet::ClientOptions options, bool lock_step) {
  if (lock_step) {
    options.silence = std::chrono::hours(1);
  }
  return options;
}

}  // namespace

NatnetInput::NatnetInput(const sylph_natnet::ClientOptions& client, StampPolicy stamp,
                         std::vector<std::string> rigid_bodies, bool simulated_time,
                         const sylph_ros::SteadyClock& clock, MeasurementSink& sink)
    : options_(client),
      simulated_time_(simulated_time),
      clock_(clock),
      sink_(sink),
      client_(clientOptions(client, clock.lockStep() != nullptr)),
      names_(std::move(rigid_bodies)),
      stamper_(stamp, clockOptions(simulated_time, clock.lockStep() != nullptr)) {
  shareStatus();
  if (const auto& lock_step = clock_.lockStep()) {
    joinLockStep(*lock_step);
  } else {
    thread_ = std::thread([this] { receive(); });
  }
}

NatnetInput::~NatnetInput() {
  stop_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void NatnetInput::joinLockStep(sylph_ros::LockStep& lock_step) {
  lock_step.setFrameSource([this](std::int32_t number) { takeFramesUpTo(number); });
  lock_step.requireAtStart([this] {
    client_.pollAll(milliseconds(1));
    followServer();
    shareStatus();
    return client_.definitionsKnown();
  });
}

void NatnetInput::takeFramesUpTo(std::int32_t number) {
  const auto deadline = steady_clock::now() + kLockStepPatience;
  do {
    try {
      auto frames = client_.pollAll(milliseconds(last_number_ < number ? 10 : 0));
      if (client_.session() != session_) {
        held_.clear();  // of a server that is gone, which counted its own numbers
      }
      for (auto& received : frames) {
        last_number_ = received.frame.number;
        held_.push_back(std::move(received));
      }
      followServer();
      handleHeldUpTo(number);
    } catch (const std::exception& error) {
      ROS_ERROR_THROTTLE(1.0, "frame dropped: %s", error.what());
    }
  } while (last_number_ < number && steady_clock::now() < deadline);
  last_number_ = std::max(last_number_, number);
  if (steady_clock::now() - last_shared_ > kStatusPeriod) {
    shareStatus();
  }
}

void NatnetInput::handleHeldUpTo(std::int32_t number) {
  while (!held_.empty() && held_.front().frame.number <= number) {
    const sylph_natnet::ReceivedFrame received = std::move(held_.front());
    held_.pop_front();
    onFrame(received);
  }
}

void NatnetInput::receive() {
  while (!stop_) {
    try {
      const auto received = client_.poll(kPollTimeout);
      followServer();
      if (received) {
        onFrame(*received);
      }
    } catch (const std::exception& error) {
      ROS_ERROR_THROTTLE(1.0, "frame dropped: %s", error.what());
    }
    if (steady_clock::now() - last_shared_ > kStatusPeriod) {
      shareStatus();
    }
  }
}

void NatnetInput::followServer() {
  if (client_.session() != session_) {
    session_ = client_.session();
    stamper_.reset();
    sink_.onRestart();
    if (const auto& server = client_.serverInfo()) {
      ROS_INFO("connected to %s at %s, bitstream %s", server->name.c_str(),
               toString(options_.server).c_str(), toString(server->version).c_str());
    }
  }
  if (client_.definitionsRevision() != definitions_revision_) {
    definitions_revision_ = client_.definitionsRevision();
    names_.update(client_.definitions());
  }
}

void NatnetInput::onFrame(const sylph_natnet::ReceivedFrame& received) {
  const double now_s = clock_.stamp().toSec();
  if (now_s <= 0.0) {
    return;  // simulated time has not begun
  }
  if (now_s < last_now_s_ - kTimeJump_s) {
    stamper_.reset();
    sink_.onRestart();
  }
  last_now_s_ = now_s;
  // Since the datagram came, while other frames were handled.
  const auto waited = std::chrono::duration<double>(steady_clock::now() - received.received);
  const double arrival_s = simulated_time_ ? now_s : now_s - waited.count();
  const auto& server = client_.serverInfo();
  const FrameTimes times = timesOf(received.frame, server ? server->ticks_per_s : 0);
  own_status_.link.bodies_in_frame = received.frame.rigid_bodies.size();
  own_status_.newest_s = times.exposure_s;
  ++own_status_.used_frames;
  if (const auto stamp_s = stamper_.stamp(times, arrival_s, echoOffset(now_s))) {
    sink_.onMeasurements(measurementsOf(received.frame, times.exposure_s, *stamp_s), now_s);
  }
}

std::optional<sylph_natnet::ClockEstimate> NatnetInput::echoOffset(double now_s) const {
  if (simulated_time_) {
    return std::nullopt;
  }
  std::optional<sylph_natnet::ClockEstimate> clock = client_.clock();
  if (clock) {
    const std::chrono::duration<double> steady = steady_clock::now().time_since_epoch();
    // The echo compares with the steady clock, stamps are in ROS time.
    clock->offset_s += now_s - steady.count();
  }
  return clock;
}

std::vector<Measurement> NatnetInput::measurementsOf(const sylph_natnet::Frame& frame,
                                                     double time_s, double stamp_s) const {
  std::vector<Measurement> measurements;
  measurements.reserve(frame.rigid_bodies.size());
  for (const sylph_natnet::RigidBodySample& body : frame.rigid_bodies) {
    const std::optional<std::size_t> robot = names_.robotOf(body.id);
    if (!robot) {
      continue;
    }
    const auto& p = body.position_m;
    const auto& q = body.orientation_xyzw;
    measurements.push_back(
        {*robot, body.tracked, {p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}, time_s, stamp_s});
  }
  return measurements;
}

void NatnetInput::shareStatus() {
  last_shared_ = steady_clock::now();
  own_status_.link.client = options_;
  own_status_.link.server = client_.serverInfo();
  own_status_.link.version = client_.version();
  own_status_.link.statistics = client_.statistics();
  own_status_.link.definitions_known = client_.definitionsKnown();
  own_status_.link.unread = client_.definitions().unread;
  own_status_.link.missing = names_.missing();
  own_status_.link.ambiguous = names_.ambiguous();
  own_status_.link.offered = names_.offered();
  own_status_.clock = stamper_.clock();
  const std::lock_guard<std::mutex> lock(mutex_);
  shared_status_ = own_status_;
}

Finding NatnetInput::look(diagnostic_updater::DiagnosticStatusWrapper& report) {
  Status status;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    status = shared_status_;
  }
  const sylph_natnet::ClientStatistics& now = status.link.statistics;
  const sylph_natnet::ClientStatistics& before = seen_status_.link.statistics;
  status.link.local_address = sylph_natnet::localAddressTowards(options_.server);
  status.link.new_frames = now.frames - before.frames;
  status.link.new_parse_errors = now.parse_errors - before.parse_errors;
  status.link.new_foreign = now.foreign - before.foreign;
  const double elapsed_s = status.newest_s - seen_status_.newest_s;
  const auto used = static_cast<double>(status.used_frames - seen_status_.used_frames);
  seen_status_ = status;

  report.add("server",
             toString(options_.server) +
                 (status.link.server ? " (" + status.link.server->name + ")" : ", silent"));
  report.add("bitstream", status.link.version ? toString(*status.link.version) : "unknown");
  report.add("frame rate [Hz]", elapsed_s > 0.0 ? used / elapsed_s : 0.0);
  report.add("frames lost", now.lost);
  report.add("frames late", now.late);
  report.add("frames superseded", now.superseded);
  report.add("parse errors", now.parse_errors);
  report.add("last parse error", now.last_error);
  report.add("bytes", now.bytes);
  report.add("datagrams of others", now.foreign);
  report.add("rigid bodies of the server", sylph::join(status.link.offered));
  if (status.clock) {
    report.add("clock offset [s]", status.clock->offset_s);
    report.add("clock uncertainty [s]", status.clock->uncertainty_s);
  }
  return preflight(status.link);
}

}  // namespace sylph_mocap_bridge
