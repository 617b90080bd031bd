#pragma once

#include <optional>
#include <vector>

#include "sylph_core/files/yaml_map.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/search/search_problem.hpp"
#include "sylph_training/imitation/scene_store.hpp"

namespace sylph_training {

/// How demonstrations are made of worlds.
struct DemonstrationSettings {
  double first_solution_s = 2.0;  ///< longest search for a first plan [s of processorTime()], > 0
  double improvement_s = 0.25;    ///< improvement of a plan [s of processorTime()], > 0
  int samples_per_world = 2000;   ///< about, > 0
  int samples_per_scene = 32;     ///< at most, > 0
  double rest_share = 0.2;  ///< chance to keep a sample of an agent that stays on its goal, 0 ... 1
  /// Samples tell only which of two or more moves that come closer to the goal is best.
  bool only_ties = false;

  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static DemonstrationSettings read(const sylph::YamlMap& yaml);
};

/// Processor time of the calling thread [s]: demonstrations are as good on a machine that other
/// work keeps busy.
double processorTime();

/// A plan by LaCAM and its anytime improvement.
/// @return none if no plan was found in time
std::optional<std::vector<sylph::Vertices>> findExpertPlan(const sylph::SearchProblem& problem,
                                                           const DemonstrationSettings& settings,
                                                           sylph::Rng& rng);

/// A plan and how the agents came to its first configuration.
struct Demonstration {
  std::vector<sylph::Vertices> plan;
  std::vector<sylph::Action> first_moves;  ///< per agent: the action before the plan begins
  int steps = 0;  ///< how many of its joint actions are of use, from the first one
};

/// Scenes of timesteps drawn from a demonstration: views, partners, the expert's actions and the
/// regrets of all others. SVOs are those of the rule of priorities, so that inputs look alike
/// whoever leads.
/// @param problem  of `instance`, but the plan may start elsewhere
void addScenes(const sylph::Instance& instance, const sylph::SearchProblem& problem,
               const Demonstration& demonstration, int samples,
               const DemonstrationSettings& settings, sylph::Rng& rng, SceneStore& store);

}  // namespace sylph_training
