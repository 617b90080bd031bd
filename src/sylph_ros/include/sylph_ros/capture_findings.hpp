#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <map>
#include <string>
#include <vector>

namespace sylph_ros {

/// What the motion-capture bridge of one fleet finds wrong, from the messages on `/diagnostics`.
class CaptureFindings {
 public:
  /// @param suite_ns  the suite's namespace in the fleet, absolute: "/sylph", "/lab/sylph"
  explicit CaptureFindings(const std::string& suite_ns);

  /// Takes over what the message says of the fleet's bridge.
  void note(const diagnostic_msgs::DiagnosticArray& diagnostics);

  /// One for each that is not OK, by name: "sylph/mocap_bridge: link: no frame from 192.168.1.2".
  std::vector<std::string> lines() const;

 private:
  std::string prefix_;  ///< of the names of its diagnostics
  std::map<std::string, std::string> findings_;
};

}  // namespace sylph_ros
