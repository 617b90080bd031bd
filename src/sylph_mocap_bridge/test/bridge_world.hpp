#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sylph_mocap_bridge/mocap_bridge_node.hpp"
#include "sylph_natnet/server.hpp"
#include "sylph_ros/wait_until.hpp"

namespace sylph_mocap_bridge::test {

using sylph_ros::waitUntil;

/// Definitions with ids 11, 12, ...
inline sylph_natnet::ModelDefinitions definitionsOf(const std::vector<std::string>& names) {
  sylph_natnet::ModelDefinitions definitions;
  for (const std::string& name : names) {
    sylph_natnet::RigidBodyDefinition body;
    body.name = name;
    body.id = 11 + static_cast<std::int32_t>(definitions.rigid_bodies.size());
    definitions.rigid_bodies.push_back(body);
  }
  return definitions;
}

/// A NatNet server that streams from a thread of its own, 120 frames a second of its clock.
class StreamingServer {
 public:
  /// The frame at a time of the server's clock [s].
  using FrameSource = std::function<sylph_natnet::Frame(double)>;

  /// @param speed    seconds of its clock per second
  /// @param begin_s  its clock at the start
  StreamingServer(const sylph_natnet::ServerOptions& options, FrameSource source,
                  double speed = 1.0, double begin_s = 1000.0)
      : server_(options), source_(std::move(source)), speed_(speed), begin_s_(begin_s) {
    thread_ = std::thread([this] { stream(); });
  }

  ~StreamingServer() {
    stop_ = true;
    thread_.join();
  }

  std::uint16_t commandPort() const { return server_.commandPort(); }
  std::uint16_t dataPort() const { return server_.dataPort(); }

  void setDefinitions(const sylph_natnet::ModelDefinitions& definitions) {
    const std::lock_guard<std::mutex> lock(mutex_);
    server_.setDefinitions(definitions);
    models_changed_ = true;
  }

  double now_s() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    return begin_s_ + speed_ * elapsed.count();
  }

 private:
  static constexpr double kPeriodS = 1.0 / 120.0;

  void stream() {
    double next_s = begin_s_;
    std::int32_t number = 0;
    while (!stop_) {
      server_.waitForCommand(std::chrono::milliseconds(1));
      const std::lock_guard<std::mutex> lock(mutex_);
      server_.serve(ticks(now_s()));
      for (; next_s <= now_s(); next_s += kPeriodS) {
        sylph_natnet::Frame frame = source_(next_s);
        frame.number = ++number;
        frame.timestamp_s = next_s - begin_s_;
        frame.mid_exposure_ticks = ticks(next_s - 0.005);
        frame.transmit_ticks = ticks(next_s);
        frame.models_changed = models_changed_;
        models_changed_ = false;
        server_.send(frame);
      }
    }
  }

  std::uint64_t ticks(double time_s) const {
    return static_cast<std::uint64_t>(time_s * static_cast<double>(server_.options().ticks_per_s));
  }

  sylph_natnet::Server server_;
  FrameSource source_;
  double speed_;
  double begin_s_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool models_changed_ = false;
  std::mutex mutex_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// Gathers what is published on a topic.
template <typename Message>
class Recorder {
 public:
  explicit Recorder(const std::string& topic) {
    subscriber_ =
        nh_.subscribe<Message>(topic, 1000, [this](const typename Message::ConstPtr& message) {
          const std::lock_guard<std::mutex> lock(mutex_);
          messages_.push_back(*message);
        });
  }

  std::vector<Message> messages() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }
  std::size_t count() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_.size();
  }
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.clear();
  }
  bool waitForMore(std::size_t more) const {
    const std::size_t enough = count() + more;
    return waitUntil([&] { return count() >= enough; });
  }

 private:
  ros::NodeHandle nh_;
  mutable std::mutex mutex_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};

/// The shipped parameters of a node that a test builds, in a namespace of their own.
class NodeParameters {
 public:
  explicit NodeParameters(const std::string& test_name) : nh_("/" + test_name) {
    XmlRpc::XmlRpcValue defaults;
    ros::param::get("~defaults", defaults);
    ros::param::set(nh_.getNamespace(), defaults);
  }
  ~NodeParameters() { ros::param::del(nh_.getNamespace()); }
  NodeParameters(const NodeParameters&) = delete;
  NodeParameters& operator=(const NodeParameters&) = delete;

  template <typename Value>
  void set(const std::string& name, const Value& value) {
    nh_.setParam(name, value);
  }
  const ros::NodeHandle& handle() const { return nh_; }

 private:
  ros::NodeHandle nh_;
};

}  // namespace sylph_mocap_bridge::test
