#include "sylph_core/search/distance_generator.hpp"

#include <utility>

#include "sylph_core/search/distance_ranking.hpp"
#include "sylph_core/search/guide_paths.hpp"
#include "sylph_core/search/pibt_generator.hpp"

namespace sylph {
namespace {

constexpr int kDetourOfGuides = 10;  // cells

std::vector<double> startDistances(const SearchProblem& problem) {
  std::vector<double> distances;
  distances.reserve(problem.starts.size());
  for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
    distances.push_back(problem.distances.get(agent, problem.starts[agent]));
  }
  return distances;
}

class DistanceGenerator : public ConfigurationGenerator {
 public:
  DistanceGenerator(const SearchProblem& problem, GuidePaths guides, Rng& rng)
      : guides_(std::move(guides)),
        ranking_(problem.distances, guides_, rng),
        pibt_(Pibt(problem.graph, problem.goals, problem.distances, problem.motion), ranking_,
              startDistances(problem)) {}

  std::vector<AgentId> order(const Vertices& configuration,
                             const std::vector<int>& waited) override {
    return pibt_.order(configuration, waited);
  }
  bool generate(const Vertices& from, const std::vector<AgentId>& order, Vertices& to) override {
    return pibt_.generate(from, order, to);
  }

 private:
  GuidePaths guides_;
  DistanceRanking ranking_;
  PibtGenerator pibt_;
};

}  // namespace

std::unique_ptr<ConfigurationGenerator> makeDistanceGenerator(const SearchProblem& problem,
                                                              const Deadline& deadline, Rng& rng) {
  GuidePaths guides = GuidePaths::spreadOut(problem.graph, problem.starts, problem.goals,
                                            problem.distances, kDetourOfGuides, deadline, rng);
  return std::make_unique<DistanceGenerator>(problem, std::move(guides), rng);
}

}  // namespace sylph
