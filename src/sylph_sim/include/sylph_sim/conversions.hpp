#pragma once

#include <geometry_msgs/Pose2D.h>
#include <sylph_msgs/InjectFault.h>

#include <cstdint>
#include <string>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_natnet/types.hpp"
#include "sylph_sim/cameras.hpp"

namespace sylph_sim {

/// Which of the motion-capture system's axes points up.
enum class UpAxis { Y, Z };

/// Rate of the simulated server's clock [1/s], that of a usual Windows performance counter.
constexpr std::uint64_t kTicksPerSecond = 10'000'000;

/// The server's clock at a simulated time. It has an epoch of its own, as real ones have.
/// @param since_start_s  simulated time since the start, >= 0
std::uint64_t toTicks(double since_start_s);

/// Streaming id of a robot's rigid body: 1, 2, ...
std::int32_t bodyId(std::size_t robot);

/// A frame as the server sends it at `frame.sent_s`. With z up its axes are those of the map; with
/// y up (x, y, z) of the map is (x, z, -y) there.
/// @param start_s        simulated time at which the server was started
/// @param body_height_m  of every body above the floor
sylph_natnet::Frame toNatNet(const CapturedFrame& frame, double start_s, UpAxis up_axis,
                             double body_height_m);

/// Names of the rigid bodies, one a robot.
sylph_natnet::ModelDefinitions modelDefinitions(const sylph::Experiment& experiment);

/// The same pose.
geometry_msgs::Pose2D toMessage(const sylph::Pose2d& pose);

/// @throws std::runtime_error or std::invalid_argument naming the kind or robot that is unknown
Fault fromMessage(const sylph_msgs::InjectFaultRequest& request,
                  const sylph::Experiment& experiment);

/// Index of a robot by its name.
/// @throws std::runtime_error if the experiment has none of that name
std::size_t robotIndex(const sylph::Experiment& experiment, const std::string& name);

}  // namespace sylph_sim
