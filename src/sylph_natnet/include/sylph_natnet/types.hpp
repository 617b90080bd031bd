#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sylph_natnet/version.hpp"

/// What a NatNet server tells. Positions and axes are the server's own, up axis included.
namespace sylph_natnet {

/// One rigid body in one frame.
struct RigidBodySample {
  std::int32_t id = 0;                                  ///< "streaming id" in Motive
  std::array<float, 3> position_m{};                    ///< x, y, z
  std::array<float, 4> orientation_xyzw{{0, 0, 0, 1}};  ///< unit quaternion if tracked
  float mean_error_m = 0;                               ///< no measure of quality by itself
  bool tracked = true;                                  ///< seen by the cameras in this frame
};
bool operator==(const RigidBodySample& a, const RigidBodySample& b);

/// Mocap data of one instant. Ticks are those of the server's clock, ServerInfo::ticks_per_s; they
/// are 0 where the server does not know them, and always before 3.0.
struct Frame {
  std::int32_t number = 0;                    ///< counts up; a gap tells of lost frames
  std::vector<RigidBodySample> rigid_bodies;  ///< in the server's order, which may change
  double timestamp_s = 0;                     ///< since the server began to stream
  float latency_s = 0;                        ///< before 3.0 only: from exposure to transmission
  std::uint64_t mid_exposure_ticks = 0;       ///< when the cameras saw it
  std::uint64_t data_received_ticks = 0;      ///< when their data had arrived at the server
  std::uint64_t transmit_ticks = 0;           ///< when the server sent the frame
  bool recording = false;                     ///< Motive is recording a take
  bool models_changed = false;                ///< model definitions must be asked for again
};
bool operator==(const Frame& a, const Frame& b);

/// The name of a rigid body, and where it hangs.
struct RigidBodyDefinition {
  std::string name;
  std::int32_t id = 0;
  std::int32_t parent_id = -1;      ///< -1: none
  std::array<float, 3> offset_m{};  ///< from the parent
};
bool operator==(const RigidBodyDefinition& a, const RigidBodyDefinition& b);

/// Names of what the server streams.
struct ModelDefinitions {
  std::vector<RigidBodyDefinition> rigid_bodies;  ///< all that the server streams
  std::vector<std::string> marker_sets;           ///< by name
  /// What ended the reading, since its length is not known: "skeleton 'person'"; what came before
  /// it is kept. Empty if all was read.
  std::string unread;
};
bool operator==(const ModelDefinitions& a, const ModelDefinitions& b);

/// Who the server is and how it streams.
struct ServerInfo {
  std::string name;                               ///< "Motive"
  std::array<std::uint8_t, 4> app_version{};      ///< of that program; says nothing on the format
  Version version;                                ///< of the bitstream: rules the format
  std::uint64_t ticks_per_s = 0;                  ///< of the server's clock; 0 before 3.0
  std::uint16_t data_port = 0;                    ///< 0 before 3.0
  bool is_multicast = true;                       ///< false: unicast
  std::array<std::uint8_t, 4> multicast_group{};  ///< 0.0.0.0 before 3.0
};
bool operator==(const ServerInfo& a, const ServerInfo& b);

/// Answer to an echo: the client's own stamp, and the server's clock when it got it.
struct EchoResponse {
  std::uint64_t client_stamp = 0;  ///< as it came in the request
  std::uint64_t server_ticks = 0;  ///< when the request came
};

}  // namespace sylph_natnet
