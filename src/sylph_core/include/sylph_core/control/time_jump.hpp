#pragma once

namespace sylph {

/// A stamp this much older than the last one means that time starts anew, as when a simulation does
/// or a clock is set [s]; one that is less older is late.
constexpr double kTimeJump_s = 1.0;

}  // namespace sylph
