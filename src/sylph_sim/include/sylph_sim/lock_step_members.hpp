#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sylph_sim {

/// Who has to act before the lab goes on, and who has.
///
/// Nodes are members from their first answer on until they end. One that does not answer for too
/// long is silent: the lab goes on without it until it answers again.
class LockStepMembers {
 public:
  /// When a member acts; StartOnly: it is waited for before the lab begins, and then never again.
  enum class Stage : std::uint8_t { First, Second, StartOnly };

  /// What a node has said.
  struct Answer {
    std::string node;
    Stage stage = Stage::Second;
    std::uint32_t number = 0;  ///< of the tick
    bool is_ready = false;     ///< for the lab to begin
    bool is_busy = false;      ///< has not acted yet, and is still at it
  };

  /// What an answer tells besides.
  struct Return {
    bool is_new = false;    ///< the node was no member, or was silent
    double silent_s = 0.0;  ///< for how long it was silent [wall s]; 0: it was not
  };

  /// @param expected  nodes without which the lab does not begin
  /// @param limit_s   without an answer for so long a member is silent [wall s]
  LockStepMembers(std::vector<std::string> expected, double limit_s)
      : expected_(std::move(expected)), limit_s_(limit_s) {}

  /// A node has ended: nobody waits for it, until it is started again and answers.
  void leave(const std::string& node) { members_.erase(node); }

  /// A tick has been sent to a stage.
  void call(Stage stage, std::uint32_t number, double wall_s);
  /// An answer has come.
  Return note(const Answer& answer, double wall_s);

  /// Whether all members of the stage that was called last have acted, but for silent ones.
  bool hasAnswered() const;
  /// Those for whom the lab does not begin.
  std::vector<std::string> unready() const;
  /// Members that are silent from now on.
  std::vector<std::string> findSilent(double wall_s);
  /// Names of members that are silent.
  std::vector<std::string> silent() const;

 private:
  struct Member {
    Stage stage = Stage::Second;
    std::uint32_t number = 0;
    bool is_ready = false;
    bool is_silent = false;
    double heard_s = 0.0;
  };

  bool isAwaited(const Member& member) const;

  std::vector<std::string> expected_;
  double limit_s_;
  std::map<std::string, Member> members_;
  Stage stage_ = Stage::First;
  std::uint32_t number_ = 0;
  double called_s_ = 0.0;
};

}  // namespace sylph_sim
