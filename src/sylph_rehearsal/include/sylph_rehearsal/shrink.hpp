#pragma once

#include <functional>
#include <vector>

#include "sylph_rehearsal/lab_fault.hpp"

namespace sylph_rehearsal {

/// A smallest schedule with which something still happens: none of its faults can be left out, and
/// none can be half as long. A fault that lasts for good counts as long as a run can be.
/// @param faults   with which it happens
/// @param happens  whether it does with others
std::vector<LabFault> shrink(std::vector<LabFault> faults,
                             const std::function<bool(const std::vector<LabFault>&)>& happens);

}  // namespace sylph_rehearsal
