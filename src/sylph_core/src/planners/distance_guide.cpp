#include "sylph_core/planners/guide.hpp"
#include "sylph_core/search/distance_generator.hpp"
#include "sylph_core/social/partners.hpp"

namespace sylph {
namespace {

class DistanceGuide : public Guide {
 public:
  DistanceGuide(const SearchProblem& problem, const Instance& instance, Rng& rng)
      : problem_(&problem), grid_(&instance.grid), rng_(&rng) {}

  std::unique_ptr<ConfigurationGenerator> makeGenerator() override {
    return makeDistanceGenerator(*problem_, 0, *rng_);
  }

  bool isPolicyGuided() const override { return false; }

  std::vector<SocialState> socialStates(const std::vector<Vertices>& plan,
                                        const Deadline& deadline) override {
    const auto distance = [this](AgentId agent, const Cell& cell) {
      return problem_->distances.fields()[static_cast<std::size_t>(agent)].at(cell);
    };
    return partnersAlongPlan(*grid_, distance, problem_->graph.toPlan(plan),
                             [&] { return deadline.isOver(); });
  }

  long policyCalls() const override { return 0; }

 private:
  const SearchProblem* problem_;
  const Grid* grid_;
  Rng* rng_;
};

}  // namespace

std::unique_ptr<Guide> makeDistanceGuide(const SearchProblem& problem, const Instance& instance,
                                         int /*threads*/, Rng& rng) {
  return std::make_unique<DistanceGuide>(problem, instance, rng);
}

}  // namespace sylph
