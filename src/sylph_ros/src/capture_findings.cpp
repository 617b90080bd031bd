#include "sylph_ros/capture_findings.hpp"

namespace sylph_ros {

// Diagnostics are named after their node, without the first slash.
CaptureFindings::CaptureFindings(const std::string& suite_ns)
    : prefix_(suite_ns.substr(1) + "/mocap_bridge: ") {}

void CaptureFindings::note(const diagnostic_msgs::DiagnosticArray& diagnostics) {
  for (const diagnostic_msgs::DiagnosticStatus& status : diagnostics.status) {
    if (status.name.rfind(prefix_, 0) != 0) {
      continue;
    }
    if (status.level == diagnostic_msgs::DiagnosticStatus::OK) {
      findings_.erase(status.name);
    } else {
      findings_[status.name] = status.message;
    }
  }
}

std::vector<std::string> CaptureFindings::lines() const {
  std::vector<std::string> lines;
  lines.reserve(findings_.size());
  for (const auto& [name, message] : findings_) {
    lines.push_back(name + ": " + message);
  }
  return lines;
}

}  // namespace sylph_ros
