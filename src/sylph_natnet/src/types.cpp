#include "sylph_natnet/types.hpp"

#include <tuple>

namespace sylph_natnet {

bool operator==(const RigidBodySample& a, const RigidBodySample& b) {
  return std::tie(a.id, a.position_m, a.orientation_xyzw, a.mean_error_m, a.tracked) ==
         std::tie(b.id, b.position_m, b.orientation_xyzw, b.mean_error_m, b.tracked);
}

bool operator==(const Frame& a, const Frame& b) {
  return std::tie(a.number, a.rigid_bodies, a.timestamp_s, a.latency_s, a.mid_exposure_ticks,
                  a.data_received_ticks, a.transmit_ticks, a.recording, a.models_changed) ==
         std::tie(b.number, b.rigid_bodies, b.timestamp_s, b.latency_s, b.mid_exposure_ticks,
                  b.data_received_ticks, b.transmit_ticks, b.recording, b.models_changed);
}

bool operator==(const RigidBodyDefinition& a, const RigidBodyDefinition& b) {
  return std::tie(a.name, a.id, a.parent_id, a.offset_m) ==
         std::tie(b.name, b.id, b.parent_id, b.offset_m);
}

bool operator==(const ModelDefinitions& a, const ModelDefinitions& b) {
  return std::tie(a.rigid_bodies, a.marker_sets, a.unread) ==
         std::tie(b.rigid_bodies, b.marker_sets, b.unread);
}

bool operator==(const ServerInfo& a, const ServerInfo& b) {
  return std::tie(a.name, a.app_version, a.version, a.ticks_per_s, a.data_port, a.is_multicast,
                  a.multicast_group) == std::tie(b.name, b.app_version, b.version, b.ticks_per_s,
                                                 b.data_port, b.is_multicast, b.multicast_group);
}

}  // namespace sylph_natnet
