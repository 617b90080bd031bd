#pragma once

#include <cstddef>
#include <deque>
#include <unordered_map>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/policy/policy_rollout.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/graph.hpp"

namespace sylph {

/// The policy's steps in the configurations that a search has come to, each asked for once.
class PolicySteps {
 public:
  /// A step and how the search came to it.
  struct Entry {
    Vertices configuration;  ///< in which the policy was asked
    const Entry* before;     ///< the step one timestep earlier, nullptr if there is none
    PolicyStep step;         ///< what it said
  };

  /// @param rollout, graph, rng  must outlive this object
  PolicySteps(PolicyRollout& rollout, const Graph& graph, Rng& rng);

  /// Asks for the step in a configuration.
  /// @param before  the configuration one timestep earlier, nullptr at the start; where its step is
  /// unknown, so is all that a step takes along but the moves that led here
  /// @return valid as long as this object
  const Entry& enter(const Vertices& configuration, const Vertices* before, StepUse use);

  /// The last step asked for in a configuration, nullptr if none was.
  const Entry* find(const Vertices& configuration) const;

  /// Number of steps asked for.
  long count() const { return static_cast<long>(entries_.size()); }

  /// Partners and SVOs at each configuration of a plan but the last. Steps that were asked for
  /// along the same way are taken from there.
  /// @return fewer, the first ones, where the time was over before
  std::vector<SocialState> along(const std::vector<Vertices>& plan, const Deadline& deadline);

 private:
  struct Hash {
    std::size_t operator()(const Vertices& configuration) const;
  };

  /// The entries of a plan's configurations but the last, empty unless each was entered after the
  /// one before it.
  std::vector<const Entry*> entriesAlong(const std::vector<Vertices>& plan) const;

  PolicyRollout* rollout_;
  const Graph* graph_;
  Rng* rng_;
  std::deque<Entry> entries_;
  std::unordered_map<Vertices, const Entry*, Hash> last_;
};

}  // namespace sylph
