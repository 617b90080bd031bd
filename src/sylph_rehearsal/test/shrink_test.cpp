#include "sylph_rehearsal/shrink.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sylph_rehearsal {
namespace {

LabFault faultOf(LabFaultKind kind, double duration_s) {
  LabFault fault;
  fault.kind = kind;
  fault.fault.duration_s = duration_s;
  return fault;
}

TEST(ShrinkTest, LeavesOutWhatIsNotNeededAndShortensTheRest) {
  // It happens with a pause of 3 s or more beside a crash of the bridge.
  const auto happens = [](const std::vector<LabFault>& faults) {
    const auto has = [&](LabFaultKind kind, double duration_s) {
      return std::any_of(faults.begin(), faults.end(), [&](const LabFault& fault) {
        return fault.kind == kind && fault.fault.duration_s >= duration_s;
      });
    };
    return has(LabFaultKind::Pause, 3.0) && has(LabFaultKind::CrashBridge, 0.0);
  };
  const std::vector<LabFault> least =
      shrink({faultOf(LabFaultKind::Stop, 1.0), faultOf(LabFaultKind::Pause, 32.0),
              faultOf(LabFaultKind::CrashPlanner, 1.0), faultOf(LabFaultKind::CrashBridge, 1.0),
              faultOf(LabFaultKind::Pause, 1.0)},
             happens);
  ASSERT_EQ(2U, least.size());
  EXPECT_EQ(LabFaultKind::Pause, least[0].kind);
  EXPECT_EQ(4.0, least[0].fault.duration_s);
  EXPECT_EQ(LabFaultKind::CrashBridge, least[1].kind);
  EXPECT_LT(least[1].fault.duration_s, 0.04);
}

}  // namespace
}  // namespace sylph_rehearsal
