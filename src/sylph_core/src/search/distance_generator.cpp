#include "sylph_core/search/distance_generator.hpp"

#include "sylph_core/search/distance_ranking.hpp"
#include "sylph_core/search/pibt_generator.hpp"

namespace sylph {
namespace {

std::vector<double> makeTieBreaks(const SearchProblem& problem, int attempt, Rng& rng) {
  std::vector<double> tie_breaks;
  tie_breaks.reserve(problem.starts.size());
  for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
    tie_breaks.push_back(attempt == 0 ? problem.distances.get(agent, problem.starts[agent])
                                      : static_cast<double>(rng()));
  }
  return tie_breaks;
}

class DistanceGenerator : public ConfigurationGenerator {
 public:
  DistanceGenerator(const SearchProblem& problem, int attempt, Rng& rng)
      : ranking_(problem.distances, rng),
        pibt_(Pibt(problem.graph, problem.goals, problem.distances, problem.motion), ranking_,
              makeTieBreaks(problem, attempt, rng)) {}

  std::vector<AgentId> order(const Vertices& configuration, const Vertices* before,
                             const std::vector<int>& waited) override {
    return pibt_.order(configuration, before, waited);
  }
  bool generate(const Vertices& from, const std::vector<AgentId>& order, Vertices& to) override {
    return pibt_.generate(from, order, to);
  }

 private:
  DistanceRanking ranking_;
  PibtGenerator pibt_;  // refers to ranking_
};

}  // namespace

std::unique_ptr<ConfigurationGenerator> makeDistanceGenerator(const SearchProblem& problem,
                                                              int attempt, Rng& rng) {
  return std::make_unique<DistanceGenerator>(problem, attempt, rng);
}

}  // namespace sylph
