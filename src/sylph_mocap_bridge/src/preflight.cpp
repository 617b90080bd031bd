#include "sylph_mocap_bridge/preflight.hpp"

#include <algorithm>

#include "sylph_core/files/nearest_names.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph_mocap_bridge {
namespace {

using sylph_natnet::Endpoint;
using sylph_natnet::toString;

std::string listOf(const std::vector<std::string>& names) {
  return names.empty() ? "none" : sylph::join(names);
}

std::string groupOf(const sylph_natnet::ServerInfo& server) {
  return toString(Endpoint{server.multicast_group, server.data_port});
}

Finding noServer(const LinkStatus& status) {
  const std::string server = toString(Endpoint{status.client.server, status.client.command_port});
  if (!status.local_address) {
    return {Severity::Error, "no network leads to the server " + server +
                                 ": check server_address and this computer's network settings"};
  }
  if (status.new_foreign > 0) {
    return {Severity::Error, "data come from " + toString(status.statistics.last_foreign) +
                                 ", not from server_address " + toString(status.client.server) +
                                 ": set server_address to the former"};
  }
  std::string text =
      "no answer from " + server + " (asked from " + toString(*status.local_address) + "): ";
  if (status.new_frames > 0) {
    text +=
        "frames do come, so the address is right; check command_port and the server's firewall "
        "(UDP), or set bitstream by hand";
  } else {
    text +=
        "is the server running with streaming on, its local interface set to the network that "
        "this computer is in (not loopback), and UDP open in its firewall? In the same "
        "network, the two addresses begin alike";
  }
  return {Severity::Error, text};
}

Finding noFrames(const LinkStatus& status) {
  const sylph_natnet::ServerInfo& server = *status.server;
  const bool knows_mode = server.data_port != 0;
  if (knows_mode && server.is_multicast && !status.client.multicast) {
    return {Severity::Error, "the server streams multicast to " + groupOf(server) +
                                 ": set transport to multicast here, or to unicast there"};
  }
  if (knows_mode && !server.is_multicast && status.client.multicast) {
    return {Severity::Error,
            "the server streams unicast: set transport to unicast here, or to multicast there"};
  }
  if (knows_mode && server.is_multicast &&
      (server.multicast_group != status.client.multicast_group ||
       server.data_port != status.client.data_port)) {
    return {Severity::Error, "the server streams to " + groupOf(server) +
                                 ": set multicast_group and data_port to these"};
  }
  std::string text =
      "the server answers but sends no frames: is streaming on and the take live, "
      "not paused in edit mode?";
  if (status.client.multicast) {
    text +=
        " If so, multicast is lost on the way: set local_interface to this computer's address "
        "in the cameras' network, use a cable, or use unicast";
  }
  return {Severity::Error, text};
}

Finding wrongNames(const LinkStatus& status) {
  if (!status.ambiguous.empty()) {
    return {Severity::Error, "more than one rigid body is called " + listOf(status.ambiguous) +
                                 ": give each a name and an id of its own"};
  }
  if (!status.definitions_known) {
    const std::string server = toString(Endpoint{status.client.server, status.client.command_port});
    return {Severity::Error, "frames come but " + server +
                                 " does not tell which rigid bodies they hold: is command_port "
                                 "the server's, and open in its firewall (UDP)?"};
  }
  if (!status.unread.empty()) {
    return {Severity::Error,
            "no rigid body called " + listOf(status.missing) + " is described before the " +
                status.unread + ", and how long that one's description is in bitstream " +
                toString(*status.version) +
                " is not known: remove it from the server's assets, or create it anew after the "
                "robots' rigid bodies; the server has, as far as known: " +
                listOf(status.offered)};
  }
  if (status.offered.empty()) {
    return {Severity::Error,
            "frames come but no rigid body is defined: create the robots' rigid bodies in the "
            "server and switch on the streaming of rigid bodies"};
  }
  return {Severity::Error, "no rigid body is called " + listOf(status.missing) +
                               "; the server has: " + listOf(status.offered)};
}

/// Of each of the names its nearest two among those that there are, without repetition.
std::vector<std::string> nearest(const std::vector<std::string>& names,
                                 const std::vector<std::string>& existing) {
  std::vector<std::string> chosen;
  for (const std::string& name : names) {
    for (const std::string& candidate : sylph::nearestNames(name, existing)) {
      if (std::find(chosen.begin(), chosen.end(), candidate) == chosen.end()) {
        chosen.push_back(candidate);
      }
    }
  }
  return chosen;
}

Finding wrongBitstream(const LinkStatus& status) {
  const std::string version = toString(*status.version);
  std::string text =
      "data are not what bitstream " + version + " says (" + status.statistics.last_error + "): ";
  if (status.client.bitstream && status.server && status.server->version != *status.version) {
    text += "the server says that it streams " + toString(status.server->version) +
            ": leave bitstream empty";
  } else if (sylph_natnet::kNewestVersion < *status.version) {
    text += "it is newer than all known here; set bitstream to \"" +
            toString(sylph_natnet::kNewestVersion) + "\" to ask the server for that one";
  } else {
    text += "set bitstream to the version that the server streams";
  }
  return {Severity::Error, text};
}

}  // namespace

Finding preflight(const LinkStatus& status) {
  if (!status.version) {
    return noServer(status);
  }
  if (status.new_parse_errors > 0) {
    return wrongBitstream(status);
  }
  if (status.new_frames == 0) {
    return status.server ? noFrames(status) : noServer(status);
  }
  if (!status.ambiguous.empty() || !status.missing.empty()) {
    return wrongNames(status);
  }
  if (status.bodies_in_frame == 0) {
    return {Severity::Error,
            "frames come without rigid bodies: switch on the streaming of rigid bodies"};
  }
  if (status.new_foreign > 0) {
    return {Severity::Warning, "a second server, " + toString(status.statistics.last_foreign) +
                                   ", sends too; its data are ignored"};
  }
  return {Severity::Ok, "frames come, all bodies are known"};
}

Finding topicsFinding(const std::vector<std::string>& unpublished,
                      const std::vector<std::string>& silent,
                      const std::vector<std::string>& existing) {
  std::string text;
  if (!unpublished.empty()) {
    text = "nobody publishes " + listOf(unpublished) + ": ";
    text += existing.empty() ? "there is no topic of poses at all, is the driver running?"
                             : "are pose_topic and the rigid bodies' names right? There is " +
                                   listOf(nearest(unpublished, existing));
  }
  if (!silent.empty()) {
    text += (text.empty() ? "" : "; ") + ("nothing comes on " + listOf(silent)) +
            ": does the driver see these bodies?";
  }
  return text.empty() ? Finding{Severity::Ok, "poses of all robots come"}
                      : Finding{Severity::Error, text};
}

bool Announcer::isDue(const Finding& finding, double now_s) {
  if (last_ && last_->severity == finding.severity) {
    const bool is_same = last_->text == finding.text;
    const double pause_s = is_same ? kRepeatS : kLeastPauseS;
    if (now_s - last_s_ < pause_s || (is_same && finding.severity == Severity::Ok)) {
      return false;
    }
  }
  last_ = finding;
  last_s_ = now_s;
  return true;
}

}  // namespace sylph_mocap_bridge
