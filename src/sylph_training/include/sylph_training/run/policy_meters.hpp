#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/policy/policy.hpp"
#include "sylph_core/policy/policy_rollout.hpp"
#include "sylph_training/run/phase.hpp"

namespace sylph_training {

/// Worlds of one kind that a policy is measured in: 32 x 32 cells, random maps with a fifth of
/// obstacles, rooms of 3 x 3 with nine tenths of the doors, mazes with a tenth of the walls opened.
struct MeterWorlds {
  /// Kind of map.
  enum class Family { Random, Room, Maze };
  Family family = Family::Random;
  int agents = 100;

  std::string name() const;  ///< such as random_100
};

/// The four kinds in which policies fail in different ways: livelock, gridlock, doors, the open.
const std::vector<MeterWorlds>& meterWorlds();

/// How much is measured, and how the policy acts meanwhile.
struct MeterSettings {
  int worlds = 24;             ///< of each kind, > 0
  int steps = 256;             ///< at most, > 0
  double temperature = 1.0;    ///< of the moves, as the planner `sylph` has it, > 0
  std::uint32_t seed = 70000;  ///< of the first world
  sylph::SvoChoice svo = sylph::SvoChoice::Mean;

  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static MeterSettings read(const sylph::YamlMap& yaml);
};

/// What a policy does in the configurations to which it leads itself, against what ReactiveTeacher
/// says there in the order of the policy's own SVOs. Decisions are those of agents that are off
/// their goal or wanted off it. A move gives way if it comes no closer to the goal.
struct PolicyMeters {
  int worlds = 0;                 ///< that were played
  int solved = 0;                 ///< of these, within the steps
  double arrived = 0.0;           ///< share of the agents on their goal at the end
  double cost_ratio = 0.0;        ///< sum of costs over its lower bound, over the solved worlds
  double non_greedy = 0.0;        ///< share of decisions in which the teacher gives way
  double recall = 0.0;            ///< of these, where the policy gives way as well
  double exact_recall = 0.0;      ///< ... with the same move
  double teacher_repeat = 0.0;    ///< ... where the teacher, asked again, has the same move
  double precision = 0.0;         ///< share of the policy's giving way where the teacher does, too
  double away_recall = 0.0;       ///< of the teacher's moves away from the goal, any move away
  double away_precision = 0.0;    ///< of the policy's moves away, where the teacher moves away
  double role_flips = 0.0;        ///< of consecutive decisions of a head-on pair: roles changed
  double gives_way_by_svo = 0.0;  ///< of a head-on pair's roles: the more prosocial one gives way
  double svo_sensitivity = 0.0;   ///< total variation of the moves of adjacent agents when one has
                                  ///< an SVO of 0 and the other of 45 degrees and they are swapped
  double svo_error_deg = 0.0;     ///< mean distance of the SVOs from the rule of priorities [deg]
  long head_on_roles = 0;         ///< that the two shares above are of
  long pairs = 0;                 ///< of adjacent agents that the sensitivity is of

  /// All of it by name, for a log or a table.
  Figures figures() const;
};

/// Plays `settings.worlds` worlds.
PolicyMeters measure(const sylph::Policy& policy, const MeterWorlds& worlds,
                     const MeterSettings& settings);

}  // namespace sylph_training
