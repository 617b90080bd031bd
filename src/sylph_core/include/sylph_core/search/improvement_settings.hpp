#pragma once

#include <array>

namespace sylph {

/// How improvement divides its time, and the constants of its searches. Where a value was measured
/// the commit that brought it in says on what; "by judgement" tells that no other has been tried.
struct ImprovementSettings {
  // First solutions, with a policy as guide; the one by distance is there within milliseconds.
  /// Of the time, at most, for that by the policy. At a quarter, 3 s in rooms with 300 agents came
  /// to 1.889 of the lower bound, by distance alone to 1.784.
  double policy_share = 0.05;
  long most_policy_steps = 1000;  ///< calls of the generator, likewise
  /// Calls after which it is known how fast the policy is; by judgement.
  long measured_policy_steps = 4;

  /// Of the time that is left then, at most, to prove how little a plan can cost. Lab maps with 8
  /// robots: of plans after 3 s, 9 of 24 are proved the cheapest in 0.2 s, 10 in 1 s.
  double proof_share = 0.1;
  int most_agents_of_proof = 16;  ///< <= 31; 560 groups of three; by judgement
  /// Of the time for the proof, at most, for one group of agents: a hard one leaves the others
  /// their time; by judgement.
  double proof_share_of_group = 0.1;

  // Rounds: with a few agents improvement soon is in a local optimum, and other starts are worth
  // more than time. The lab maze with 8 agents: 195 and 233 of cost where one round has 247 to 296.
  int most_agents_of_rounds = 16;  ///< with more there is one round
  int rounds = 4;                  ///< of equal length; by judgement
  /// The first solutions took less than this share of the time that is left: on a computer so busy
  /// that they take longer, rounds are too short and cost a fifth.
  double most_first_solution_share = 0.05;

  // Restarts from configurations of the plan, before all else.
  /// Of the time, at most. Mazes with 128 agents: 5.30 -> 4.43 of the lower bound in 4 s.
  double restart_share = 0.15;
  int most_failed_restarts = 30;  ///< in a row, then restarts end; by judgement
  /// Every so many restarts begin at the start: the first steps decide much, and a random
  /// configuration is seldom among them; by judgement.
  int restarts_per_start = 3;
  /// Most calls of the generator per step that is left of the plan: a way twice as long as the one
  /// known is no better one; by judgement.
  long steps_per_step = 2;

  // Turns of large-neighbourhood search and LaCAM*.
  /// Turns in the time, so that threads exchange their plans often; by judgement.
  double turns = 50.0;
  double longest_turn_s = 0.5;  ///< [s], so that a long limit has more of them; by judgement

  // LaCAM* beside large-neighbourhood search.
  /// So many can be searched exhaustively: lab instances are proved optimal; by judgement.
  int few_agents = 10;
  double lacam_share_of_few = 0.5;  ///< of a turn, with few agents; by judgement
  /// With more agents: 1.37 -> 1.31 of the lower bound in half the time, random maps with 300
  /// agents, along with faster neighbourhoods.
  double lacam_share = 0.05;
  long most_vertices_kept = 30'000'000;  ///< configurations times agents: about 1 GB of memory

  // Large-neighbourhood search. Its table has a layer for each timestep.
  /// Of all threads together: larger maps are improved by restarts; by judgement, half of the 2 GB
  /// that a planner may take.
  double most_table_bytes = 1e9;
  double table_bytes_per_s = 1e9;  ///< how fast a table is filled; by judgement: a slow memory
  double table_share = 0.1;        ///< of the time, at most, to fill the first one; by judgement
  /// Loss in cost accepted on average at the beginning, falling linearly to 0 at the end as in
  /// simulated annealing; by judgement: the least loss there is.
  double first_temperature = 1.0;
  /// Losses are accepted from the first turn on that gained less than this share of the cost: until
  /// then there is enough to be had without; by judgement.
  double plentiful_gain = 0.001;
  /// Agents in a neighbourhood. Li et al. 2021 compare 2 to 16; 32 pays on crowded maps.
  std::array<int, 5> neighborhood_sizes = {2, 4, 8, 16, 32};
  double exploration =
      0.2;  ///< share of neighbourhoods drawn without regard to gains; by judgement
  double reaction_factor = 0.01;  ///< weight of the last gain in its mean; as Li et al. 2021
  int walks = 10;                 ///< most walks for one neighbourhood; as Li et al. 2021
  int jam_reach = 3;  ///< timesteps before and after a jam that belong to it; by judgement
  /// How often the table may get shorter: it is copied then; by judgement.
  int neighborhoods_between_shrinks = 256;

  // Time that is left for the social states along the improved plan, where a policy is the guide.
  double most_social_share = 0.5;    ///< of what is left then, at most; by judgement
  double least_social_share = 0.01;  ///< of that, however fast the policy was; by judgement
  int measured_social_steps = 8;     ///< steps after which it is known how fast it is; by judgement
};

}  // namespace sylph
