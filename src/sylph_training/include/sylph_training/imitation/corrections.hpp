#pragma once

#include <memory>

#include "sylph_core/policy/policy.hpp"
#include "sylph_training/imitation/shards.hpp"

namespace sylph_training {

/// How the expert corrects a policy where the policy itself leads (DAgger: Ross et al. 2011, "A
/// Reduction of Imitation Learning and Structured Prediction to No-Regret Online Learning").
struct CorrectionSettings {
  int round = 1;             ///< which round of corrections: those of earlier ones are used as well
  int shards = 25;           ///< of this round, > 0
  int worlds_per_shard = 8;  ///< > 0
  double share = 0.4;        ///< of the samples of a batch, 0 ... 1
  int most_steps = 256;      ///< that the policy leads in a world, > 0
  Interval every{6, 20};     ///< steps from one correction to the next
  int steps = 10;            ///< of the expert's plan that are of use, > 0
  int samples = 250;         ///< of one correction, about, > 0
  double improvement_s = 0.12;  ///< of the expert's plan [s], > 0

  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static CorrectionSettings read(const sylph::YamlMap& yaml);
};

/// Scenes along the expert's plans from configurations to which the planner `sylph_pibt` came with
/// a policy.
SceneSource correctedScenes(std::shared_ptr<const sylph::Policy> policy,
                            const CorrectionSettings& settings,
                            const DemonstrationSettings& demonstrations);

}  // namespace sylph_training
