#include "sylph_rehearsal/shrink.hpp"

#include <algorithm>
#include <utility>

namespace sylph_rehearsal {
namespace {

constexpr double kLongest_s = 64.0;
constexpr double kShortest_s = 0.02;

}  // namespace

std::vector<LabFault> shrink(std::vector<LabFault> faults,
                             const std::function<bool(const std::vector<LabFault>&)>& happens) {
  for (std::size_t i = 0; i < faults.size();) {
    std::vector<LabFault> fewer = faults;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (happens(fewer)) {
      faults = std::move(fewer);
      i = 0;  // what was needed beside this one may be needed no more
    } else {
      ++i;
    }
  }
  for (std::size_t i = 0; i < faults.size(); ++i) {
    std::vector<LabFault> shorter = faults;
    double& duration_s = shorter[i].fault.duration_s;
    duration_s = std::min(duration_s, kLongest_s);
    for (duration_s /= 2.0; duration_s >= kShortest_s && happens(shorter); duration_s /= 2.0) {
      faults = shorter;
    }
  }
  return faults;
}

}  // namespace sylph_rehearsal
