#pragma once

#include <memory>
#include <vector>

#include "sylph_core/policy/policy.hpp"
#include "sylph_training/imitation/shards.hpp"
#include "sylph_training/imitation/team_state.hpp"

namespace sylph_training {

/// How scenes are made in which a ReactiveTeacher labels whatever configuration comes about.
struct ReactiveSettings {
  double share = 0.8;       ///< of the samples of a batch, 0 ... 1; the rest are demonstrations
  int teacher_shards = 40;  ///< led by the teacher, made before anything is learned, > 0
  int student_steps = 60;   ///< steps of learning from one shard led by the policy to the next, > 0
  double student_share =
      0.5;  ///< of the samples labelled by the teacher, once there are any, 0 ... 1
  int worlds_per_shard = 24;     ///< > 0
  int most_agents = 160;         ///< in worlds that the policy leads, > 0
  int most_steps = 250;          ///< of one world, > 0
  int samples_per_world = 1500;  ///< about, of a team that gets on, > 0
  int samples_per_scene = 64;    ///< at most, > 0
  double scene_share = 0.6;      ///< of the timesteps become scenes at most, above 0 and at most 1
  double rest_share = 0.12;      ///< of the agents that stay on their goal are samples, 0 ... 1
  double greedy_share = 0.6;     ///< of those that come closer to it, 0 ... 1
  int draws = 4;                 ///< of the teacher's desired actions for one label, > 0
  double mistakes = 0.6;  ///< highest share of moves that come no closer which the leading teacher
                          ///< fails to make, 0 ... 1
  double perturbed =
      0.2;  ///< of the scenes have SVOs that the rule of priorities does not give, 0 ... 1
  bool by_preference = true;  ///< where the policy leads, the teacher's taste is the policy's

  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static ReactiveSettings read(const sylph::YamlMap& yaml);
};

/// Scenes where the teacher leads and now and then fails to give way.
SceneSource teacherLedScenes(const ReactiveSettings& settings);

/// Scenes where a policy leads, each choosing its moves as the planner `sylph` has it: what is
/// learned there mends what it does wrong (DAgger: Ross et al. 2011, "A Reduction of Imitation
/// Learning and Structured Prediction to No-Regret Online Learning").
SceneSource studentLedScenes(std::shared_ptr<const sylph::Policy> policy,
                             const ReactiveSettings& settings);

/// One draw for each agent from the softmax of its logits / temperature over the actions that hit
/// nothing.
/// @param logits  n x 5
std::vector<sylph::Action> drawDesiredActions(const TeamState& team, const sylph::AgentRows& logits,
                                              double temperature, sylph::Rng& rng);

}  // namespace sylph_training
