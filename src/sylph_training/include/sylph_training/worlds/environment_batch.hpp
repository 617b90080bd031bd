#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/social/svo.hpp"
#include "sylph_training/model/policy_model.hpp"
#include "sylph_training/worlds/environment.hpp"

namespace sylph_training {

/// Where SVOs come from. All but the first are ablations: He et al. 2024 (arXiv:2408.03063),
/// "Ablation" and "Random SVO Training Results".
enum class SvoMode {
  Learned,           ///< drawn from the network's distribution; the most prosocial level on a goal
  Off,               ///< all selfish and nobody has a partner
  RandomPerStep,     ///< any level, anew at each step
  RandomPerPartner,  ///< ... when the partner changes
  RandomPerEpisode,  ///< ... at the start
};

/// What is fed back to the network as the SVO of the step before.
enum class SvoFeedback {
  Sample,        ///< the level that was drawn, so that agents in equal places can come to differ
  Distribution,  ///< the distribution that it was drawn from, as the planners and the authors do
};

/// Where SVOs come from, and what the network hears of them.
struct SvoOptions {
  SvoMode mode = SvoMode::Learned;
  SvoFeedback feedback = SvoFeedback::Distribution;
};

/// Draws the world of an episode.
using WorldSource = std::function<sylph::Instance(sylph::Rng&)>;

/// How an episode went.
struct EpisodeRecord {
  int world = 0;                 ///< of the batch
  int agents = 0;                ///< of the world
  int steps = 0;                 ///< that the episode took
  bool is_solved = false;        ///< all on their goals at its end
  int arrived = 0;               ///< agents on their goals at the end
  double external_reward = 0.0;  ///< summed over agents and steps
  int blocked = 0;               ///< agents blocked by others that rest, summed over the steps
  int collisions = 0;            ///< penalties for collisions averted, likewise
};

/// What one step of all worlds brought. Rows are agents, those of a world side by side.
struct BatchStep {
  std::vector<std::int64_t> svo_levels;  ///< per row: the level drawn
  std::vector<float> svo;                ///< rows x levels: what is fed back
  std::vector<float> has_svo_choice;     ///< per row: 1 if it was drawn from the network's output
  std::vector<float> external_rewards;   ///< per row
  std::vector<float> social_rewards;     ///< per row
  std::vector<float> action_rewards;     ///< per row
  std::vector<bool> is_penalized;        ///< per row: to blame for a collision averted
  std::vector<char> is_finished, is_solved;  ///< per world, after the step
};

/// A number of worlds that go on side by side, each with a generator of its own, and what the
/// network needs to know of all their agents.
class EnvironmentBatch {
 public:
  /// Probability of each level.
  using SvoDistribution = std::array<float, sylph::kSvoLevelCount>;

  /// @param worlds  > 0
  /// @throws std::invalid_argument if the options or the number of worlds is not valid
  EnvironmentBatch(WorldSource source, const EnvironmentOptions& environment, const SvoOptions& svo,
                   int worlds, std::uint32_t seed);

  int worldCount() const { return static_cast<int>(worlds_.size()); }
  /// Row of each world's first agent, then the number of rows.
  const std::vector<std::int64_t>& firstRows() const { return first_rows_; }
  /// Agents of all worlds.
  std::int64_t rowCount() const { return first_rows_.back(); }
  /// @param index  0 ... worldCount() - 1
  const Environment& world(int index) const;

  /// Everything but the memory. Views are a x channels x 9 x 9, in the memory the channels last.
  PolicyInput observe() const;
  /// Row of each row's partner.
  std::vector<std::int64_t> partnerRows() const;

  /// @param desired             one per row
  /// @param svo_probabilities  rows x svo levels, on the host
  BatchStep step(const std::vector<sylph::Action>& desired, const torch::Tensor& svo_probabilities);

  /// Starts new episodes in the worlds whose episodes have ended.
  /// @return per row now the row that the agent had before, -1 if its episode is new
  std::vector<std::int64_t> resetFinished();

  /// Episodes that ended since this was asked last.
  std::vector<EpisodeRecord> takeRecords();

  /// For whoever draws actions for a world: its own generator, so that worlds do not depend on one
  /// another.
  sylph::Rng& rngOfWorld(int index);

 private:
  struct World {
    sylph::Rng rng;
    std::unique_ptr<Environment> environment;
    std::vector<SvoDistribution> svo;      // per agent, as fed back
    std::vector<int> levels;               // per agent, drawn last
    std::vector<sylph::AgentId> partners;  // per agent, at the step before
    EpisodeRecord record;
  };

  void start(World& world);
  void showProsocialOnGoal(World& world) const;
  void chooseSvo(World& world, std::size_t agent, const float* probabilities, StepSvo& svo,
                 BatchStep& step) const;
  void stepWorld(int index, const sylph::Action* desired, const float* svo_probabilities,
                 BatchStep& step);
  void countRows();

  WorldSource source_;
  EnvironmentOptions environment_options_;
  SvoOptions svo_options_;
  std::vector<World> worlds_;
  std::vector<std::int64_t> first_rows_;
  std::vector<EpisodeRecord> records_;
};

/// Draws an index with the given probabilities, which need not sum to 1.
/// @param probabilities  `count` numbers >= 0
int drawFrom(const float* probabilities, int count, sylph::Rng& rng);

}  // namespace sylph_training
