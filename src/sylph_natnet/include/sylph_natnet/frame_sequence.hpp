#pragma once

#include <cstdint>
#include <optional>

namespace sylph_natnet {

/// Follows frame numbers: what is new, what came too late, what was lost, when the server began
/// anew.
class FrameSequence {
 public:
  /// What a frame number tells.
  enum class Verdict {
    New,      ///< newer than all before
    Late,     ///< overtaken by a newer one, or a duplicate
    Restart,  ///< the numbers began anew
  };

  /// A number that is at most this much older than the newest is late; an older one is a restart.
  static constexpr std::int64_t kLateWindow = 100;

  /// Takes the number of a frame that has come.
  Verdict accept(std::int32_t number);
  /// The next number begins anew; the counters stay.
  void restart() { newest_.reset(); }

  /// Numbers that were left out so far and did not come late either.
  std::uint64_t lost() const { return lost_; }
  /// Numbers with the verdict Late so far.
  std::uint64_t late() const { return late_; }

 private:
  std::optional<std::int64_t> newest_;
  std::uint64_t lost_ = 0;
  std::uint64_t late_ = 0;
};

}  // namespace sylph_natnet
