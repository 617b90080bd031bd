#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/search_problem.hpp"
#include "sylph_core/social/social_state.hpp"

namespace sylph {

/// What tells one kind of planner from another: how a joint step comes about, and what is known of
/// the agents' social behaviour. One for each call of Planner::plan().
class Guide {
 public:
  virtual ~Guide() = default;

  /// Its joint steps; must not outlive the guide.
  virtual std::unique_ptr<ConfigurationGenerator> makeGenerator() = 0;
  /// Whether a policy guides it; otherwise it is makeDistanceGenerator()'s.
  virtual bool isPolicyGuided() const = 0;

  /// Partners and SVOs along a plan.
  /// @return one per joint action; fewer, the first ones, where the time was over before
  virtual std::vector<SocialState> socialStates(const std::vector<Vertices>& plan,
                                                const Deadline& deadline) = 0;

  /// Network evaluations so far.
  virtual long policyCalls() const = 0;
};

/// The arguments outlive the result.
using GuideFactory = std::function<std::unique_ptr<Guide>(
    const SearchProblem& problem, const Instance& instance, int threads, Rng& rng)>;

/// Joint steps by distance to the goal, see makeDistanceGenerator(). Partners are those of Alg. 1
/// and 2, SVOs are unknown.
std::unique_ptr<Guide> makeDistanceGuide(const SearchProblem& problem, const Instance& instance,
                                         int threads, Rng& rng);

}  // namespace sylph
