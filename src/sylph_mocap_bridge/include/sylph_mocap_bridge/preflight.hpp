#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sylph_natnet/client.hpp"

namespace sylph_mocap_bridge {

/// What is known of the way from the cameras to the robots' poses.
struct LinkStatus {
  sylph_natnet::ClientOptions client;                      ///< as it was told to connect
  std::optional<sylph_natnet::Ipv4Address> local_address;  ///< from which the server is reached
  std::optional<sylph_natnet::ServerInfo> server;          ///< nothing while it has not answered
  /// Of the bitstream; nothing while it is not known.
  std::optional<sylph_natnet::Version> version;
  sylph_natnet::ClientStatistics statistics;  ///< since the start
  std::uint64_t new_frames = 0;               ///< since the last look
  std::uint64_t new_parse_errors = 0;         ///< since the last look
  std::uint64_t new_foreign = 0;              ///< since the last look
  std::size_t bodies_in_frame = 0;            ///< rigid bodies in the last frame
  bool definitions_known = false;             ///< the server told what bodies it has
  std::string unread;                         ///< what hides the rest of them, see ModelDefinitions
  std::vector<std::string> missing;           ///< robots' bodies that the server does not have
  std::vector<std::string> ambiguous;         ///< robots' bodies that it has more than once
  std::vector<std::string> offered;           ///< all bodies that it has
};

enum class Severity { Ok, Warning, Error };  ///< Of a finding, as in diagnostics

/// One thing that is wrong, or that nothing is.
struct Finding {
  Severity severity = Severity::Ok;
  std::string text;  ///< what is wrong and what to do about it, one line
};

/// The first thing that is wrong on the way from the cameras, from wrong network over streaming
/// switched off and wrong mode to wrong names.
Finding preflight(const LinkStatus& status);

/// What is wrong with the pose topics of another driver; all topics that lack are named.
/// @param unpublished  topics that nobody publishes
/// @param silent       topics that are published but bring nothing
/// @param existing     topics of poses that others publish: those most like the unpublished ones
/// are
///                     told
Finding topicsFinding(const std::vector<std::string>& unpublished,
                      const std::vector<std::string>& silent,
                      const std::vector<std::string>& existing);

/// Tells when a finding is worth a line on the screen: when it is another one, and now and then
/// while something stays wrong, since the line of the start has scrolled away by then. Findings
/// that change all the time make no flood.
class Announcer {
 public:
  static constexpr double kRepeatS = 30.0;
  static constexpr double kLeastPauseS = 5.0;  ///< between findings of one severity

  /// @param now_s  of a steady clock
  bool isDue(const Finding& finding, double now_s);

 private:
  std::optional<Finding> last_;
  double last_s_ = 0.0;
};

}  // namespace sylph_mocap_bridge
