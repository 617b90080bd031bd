#include "sylph_core/search/distance_generator.hpp"

#include <vector>

#include "sylph_core/search/distance_ranking.hpp"
#include "sylph_core/search/pibt_steps.hpp"

namespace sylph {
namespace {

std::vector<double> makeTieBreaks(const SearchProblem& problem, int attempt, Rng& rng) {
  std::vector<double> tie_breaks;
  tie_breaks.reserve(problem.starts.size());
  for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
    // Okumura et al. 2022 begin with who has farthest to go; a search that starts anew tries its
    // luck with another order.
    tie_breaks.push_back(attempt == 0 ? problem.distances.get(agent, problem.starts[agent])
                                      : drawFraction(rng));
  }
  return tie_breaks;
}

class DistanceGenerator : public ConfigurationGenerator {
 public:
  DistanceGenerator(const SearchProblem& problem, int attempt, Rng& rng)
      : ranking_(problem.distances, rng),
        pibt_(problem),
        tie_breaks_(makeTieBreaks(problem, attempt, rng)) {}

  std::unique_ptr<JointSteps> enter(const Vertices& configuration, const Vertices* /*before*/,
                                    const Priorities& priorities) override {
    return std::make_unique<PibtSteps>(pibt_, ranking_, configuration,
                                       orderByPriority(priorities, tie_breaks_));
  }

 private:
  DistanceRanking ranking_;
  Pibt pibt_;
  std::vector<double> tie_breaks_;
};

}  // namespace

std::unique_ptr<ConfigurationGenerator> makeDistanceGenerator(const SearchProblem& problem,
                                                              int attempt, Rng& rng) {
  return std::make_unique<DistanceGenerator>(problem, attempt, rng);
}

}  // namespace sylph
