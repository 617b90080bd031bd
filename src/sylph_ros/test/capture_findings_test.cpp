#include "sylph_ros/capture_findings.hpp"

#include <gtest/gtest.h>

namespace sylph_ros {
namespace {

diagnostic_msgs::DiagnosticArray diagnostics(const std::string& name, std::int8_t level,
                                             const std::string& message) {
  diagnostic_msgs::DiagnosticArray array;
  array.status.resize(1);
  array.status[0].name = name;
  array.status[0].level = static_cast<decltype(array.status[0].level)>(level);
  array.status[0].message = message;
  return array;
}

TEST(CaptureFindingsTest, KeepsWhatTheFleetsOwnBridgeFindsUntilItIsMended) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  CaptureFindings findings("/lab/sylph");
  findings.note(diagnostics("lab/sylph/mocap_bridge: link", Status::ERROR, "no frame"));
  findings.note(diagnostics("lab/sylph/mocap_bridge: bodies", Status::WARN, "cf1 is not seen"));
  findings.note(diagnostics("sylph/mocap_bridge: link", Status::ERROR, "of another fleet"));
  findings.note(diagnostics("lab/sylph/sylph_planner: mission", Status::WARN, "of another node"));
  EXPECT_EQ((std::vector<std::string>{"lab/sylph/mocap_bridge: bodies: cf1 is not seen",
                                      "lab/sylph/mocap_bridge: link: no frame"}),
            findings.lines());
  findings.note(diagnostics("lab/sylph/mocap_bridge: link", Status::OK, "receives"));
  EXPECT_EQ((std::vector<std::string>{"lab/sylph/mocap_bridge: bodies: cf1 is not seen"}),
            findings.lines());
}

}  // namespace
}  // namespace sylph_ros
