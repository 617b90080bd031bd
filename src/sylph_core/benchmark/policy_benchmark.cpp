// Where a step of the policy spends its time: the network, what it sees, partners, the joint step.
// Items are agent steps. Untrained weights of the default width: values change nothing.

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/policy/policy_rollout.hpp"
#include "sylph_core/search/pibt.hpp"
#include "sylph_core/search/pibt_steps.hpp"
#include "sylph_core/search/policy_ranking.hpp"
#include "sylph_core/social/partners.hpp"
#include "test/support/random_weights.hpp"

namespace sylph {
namespace {

const Policy& defaultPolicy() {
  static const Policy policy(RandomWeights(NetworkShape(), 1).file(), "random weights");
  return policy;
}

/// Agents on a random map of 32 x 32 cells, 20 % blocked, some steps after the start.
class Crowd {
 public:
  explicit Crowd(int agents)
      : instance_(randomInstance(randomMap(RandomMapSpec(), rng_), agents, {}, rng_)),
        problem_(instance_),
        pibt_(problem_) {
    const AgentRows indifferent = AgentRows::Zero(agents, kActionCount);
    for (int timestep = 0; timestep < kTimesteps; ++timestep) {
      cells_.push_back(problem_.graph.toCells(vertices_));
      step(indifferent);
    }
  }

  const Instance& instance() const { return instance_; }
  const std::vector<DistanceField>& distances() const { return problem_.distances.fields(); }
  /// Configurations, one timestep after the other.
  const std::vector<Configuration>& cells() const { return cells_; }

  void step(const AgentRows& actions) {
    const MoveSettings settings;
    PolicyRanking ranking(problem_, settings, actions, priorities_, rng_);
    Vertices next(vertices_.size(), kNoVertex);
    pibt_.step(vertices_, orderByPriority(priorities_, tie_breaks_), ranking, next);
    vertices_ = next;
  }

 private:
  static constexpr int kTimesteps = 16;

  Rng rng_{1};
  Instance instance_;
  SearchProblem problem_;
  Pibt pibt_;
  Vertices vertices_ = problem_.starts;
  Priorities priorities_ = Priorities(vertices_.size(), 1);
  std::vector<double> tie_breaks_ = std::vector<double>(vertices_.size(), 0.0);
  std::vector<Configuration> cells_;
};

void countAgentSteps(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void network(benchmark::State& state) {
  const auto agents = static_cast<Eigen::Index>(state.range(0));
  const NetworkShape shape;
  NetworkInput input;
  input.views = AgentRows::Random(agents, kObservationSize);
  input.vectors = AgentRows::Random(agents, kVectorSize);
  input.svo = AgentRows::Constant(agents, shape.svo_levels, 0.1F);
  input.memory = AgentRows::Zero(agents, shape.width);
  for (int agent = 0; agent < static_cast<int>(agents); ++agent) {
    input.partners.push_back(agent / 2 * 2);
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(defaultPolicy().network().forward(input));
  }
  countAgentSteps(state);
  state.counters["multiply-adds"] = static_cast<double>(defaultPolicy().network().multiplyAdds());
}

void observation(benchmark::State& state) {
  const Crowd crowd(static_cast<int>(state.range(0)));
  ObservationEncoder encoder(crowd.instance().grid, crowd.distances());
  const std::size_t count = crowd.instance().starts.size();
  const AgentStates states = {crowd.cells().back(), std::vector<Action>(count, Action::North),
                              std::vector<float>(count, 20.F), std::vector<int>(count, 1),
                              std::vector<float>(count, 0.5F)};
  AgentRows views(state.range(0), kObservationSize);
  AgentRows vectors(state.range(0), kVectorSize);
  for (auto _ : state) {
    encoder.setStates(states);
    for (Eigen::Index agent = 0; agent < views.rows(); ++agent) {
      encoder.encode(static_cast<AgentId>(agent), views.row(agent).data(),
                     vectors.row(agent).data());
    }
    benchmark::ClobberMemory();
  }
  countAgentSteps(state);
}

void partners(benchmark::State& state) {
  const Crowd crowd(static_cast<int>(state.range(0)));
  const auto distance = [&](AgentId agent, const Cell& cell) {
    return crowd.distances()[static_cast<std::size_t>(agent)].at(cell);
  };
  Partners chosen(crowd.instance().grid, distance, crowd.cells().front());
  std::size_t timestep = 0;
  for (auto _ : state) {
    timestep = (timestep + 1) % crowd.cells().size();
    chosen.update(crowd.cells()[timestep]);
  }
  countAgentSteps(state);
}

void jointStep(benchmark::State& state) {
  Crowd crowd(static_cast<int>(state.range(0)));
  const AgentRows actions = AgentRows::Random(state.range(0), kActionCount);
  for (auto _ : state) {
    crowd.step(actions);
  }
  countAgentSteps(state);
}

void wholeStep(benchmark::State& state) {
  const Crowd crowd(static_cast<int>(state.range(0)));
  Rng rng(1);
  PolicyRollout rollout(defaultPolicy(), crowd.instance().grid, crowd.distances(), SvoChoice::Mean,
                        static_cast<int>(state.range(1)), rng);
  PolicyStep step = rollout.nothingKnown();
  std::size_t timestep = 0;
  for (auto _ : state) {
    const std::size_t next = (timestep + 1) % crowd.cells().size();
    step = rollout.follow(step, crowd.cells()[timestep], crowd.cells()[next], rng);
    timestep = next;
  }
  countAgentSteps(state);
}

BENCHMARK(network)->Arg(8)->Arg(200)->Unit(benchmark::kMillisecond);
BENCHMARK(observation)->Arg(8)->Arg(200)->Unit(benchmark::kMillisecond);
BENCHMARK(partners)->Arg(8)->Arg(200)->Unit(benchmark::kMillisecond);
BENCHMARK(jointStep)->Arg(8)->Arg(200)->Unit(benchmark::kMillisecond);
// Agents and threads.
BENCHMARK(wholeStep)->ArgsProduct({{8, 200}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace sylph

BENCHMARK_MAIN();
