#include "sylph_natnet/frame_sequence.hpp"

#include <algorithm>

namespace sylph_natnet {

FrameSequence::Verdict FrameSequence::accept(std::int32_t number) {
  if (!newest_) {
    newest_ = number;
    return Verdict::New;
  }
  const std::int64_t step = number - *newest_;
  if (step > 0) {
    lost_ += static_cast<std::uint64_t>(step - 1);
    newest_ = number;
    return Verdict::New;
  }
  if (step >= -kLateWindow) {
    ++late_;
    // A frame that was counted as lost has come after all; a duplicate of the newest was not lost.
    lost_ -= step < 0 ? std::min<std::uint64_t>(lost_, 1) : 0;
    return Verdict::Late;
  }
  newest_ = number;
  return Verdict::Restart;
}

}  // namespace sylph_natnet
