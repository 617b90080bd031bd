#include "sylph_training/imitation/demonstration.hpp"

#include <time.h>  // NOLINT(modernize-deprecated-headers): clock_gettime() is POSIX

#include <algorithm>
#include <numeric>
#include <utility>

#include "sylph_core/planners/first_solution.hpp"
#include "sylph_core/planners/improvement.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/distance_generator.hpp"
#include "sylph_core/social/partners.hpp"
#include "sylph_core/social/precedence.hpp"

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::AgentId;
using sylph::Cell;

/// Turns timesteps of one demonstration into scenes.
class SceneMaker {
 public:
  SceneMaker(const sylph::Instance& instance, const sylph::SearchProblem& problem,
             const Demonstration& demonstration, const DemonstrationSettings& settings,
             sylph::Rng& rng)
      : settings_(&settings),
        rng_(&rng),
        goals_(instance.goals),
        plan_(problem.graph.toPlan(demonstration.plan)),
        first_moves_(demonstration.first_moves),
        encoder_(instance.grid, problem.distances.fields()) {
    for (std::size_t agent = 0; agent < goals_.size(); ++agent) {
      tie_breaks_.push_back(static_cast<float>(sylph::drawFraction(rng)));
    }
    const RegretTable table(problem, demonstration.plan);
    for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
      regrets_.push_back(table.of(agent));
    }
    const auto distance = [&problem](AgentId agent, const Cell& cell) {
      return problem.distances.fields()[static_cast<std::size_t>(agent)].at(cell);
    };
    social_ = sylph::partnersAlongPlan(instance.grid, distance, plan_);
  }

  Scene make(std::size_t timestep) {
    const std::vector<Action> actions = actionsAt(timestep);
    sylph::AgentStates states;
    states.cells = plan_[timestep];
    states.last_moves = timestep == 0 ? first_moves_ : actionsAt(timestep - 1);
    states.tie_breaks = tie_breaks_;
    Scene scene;
    for (std::size_t agent = 0; agent < goals_.size(); ++agent) {
      states.priorities.push_back(priorityOf(agent, timestep));
      states.svo_deg.push_back(sylph::svoByPriority(states.priorities[agent], tie_breaks_[agent]));
      SceneAgent known;
      known.partner = static_cast<std::uint16_t>(social_[timestep].partners[agent]);
      known.svo_centideg = toCentidegrees(states.svo_deg[agent]);
      scene.agents.push_back(known);
    }
    encoder_.setStates(states);
    const std::vector<bool> is_sample = drawSamples(states.cells, actions);
    std::vector<float> view(sylph::kObservationSize);
    for (std::size_t agent = 0; agent < goals_.size(); ++agent) {
      encoder_.encode(static_cast<AgentId>(agent), view.data(), scene.agents[agent].vector.data());
      if (is_sample[agent]) {
        Sample sample;
        sample.agent = static_cast<std::uint16_t>(agent);
        sample.action = static_cast<std::uint8_t>(actions[agent]);
        sample.only_ties = settings_->only_ties ? 1 : 0;
        sample.regrets = regrets_[agent][timestep];
        sample.view = packView(view.data());
        scene.samples.push_back(sample);
      }
    }
    return scene;
  }

 private:
  std::vector<Action> actionsAt(std::size_t timestep) const {
    std::vector<Action> actions;
    for (std::size_t agent = 0; agent < goals_.size(); ++agent) {
      actions.push_back(
          sylph::actionBetween(plan_[timestep][agent], plan_[timestep + 1][agent]).value());
    }
    return actions;
  }

  // Agents that rest on their goal are many and teach little: most are left out.
  std::vector<bool> drawSamples(const sylph::Configuration& cells,
                                const std::vector<Action>& actions) {
    std::vector<std::size_t> drawn;
    for (std::size_t agent = 0; agent < goals_.size(); ++agent) {
      const bool rests = cells[agent] == goals_[agent] && actions[agent] == Action::Stay;
      if (!rests || sylph::drawFraction(*rng_) < settings_->rest_share) {
        drawn.push_back(agent);
      }
    }
    sylph::shuffle(drawn, *rng_);
    drawn.resize(std::min(drawn.size(), static_cast<std::size_t>(settings_->samples_per_scene)));
    std::vector<bool> is_sample(goals_.size(), false);
    for (const std::size_t agent : drawn) {
      is_sample[agent] = true;
    }
    return is_sample;
  }

  // Timesteps since the agent was last on its goal.
  int priorityOf(std::size_t agent, std::size_t timestep) const {
    int priority = 0;
    while (plan_[timestep][agent] != goals_[agent]) {
      ++priority;
      if (timestep-- == 0) {
        break;
      }
    }
    return priority;
  }

  const DemonstrationSettings* settings_;
  sylph::Rng* rng_;
  sylph::Configuration goals_;
  sylph::Plan plan_;
  std::vector<Action> first_moves_;
  std::vector<float> tie_breaks_;
  sylph::ObservationEncoder encoder_;          // refers to the problem's distances
  std::vector<std::vector<Regrets>> regrets_;  // per agent and joint action
  std::vector<sylph::SocialState> social_;     // per joint action
};

}  // namespace

DemonstrationSettings DemonstrationSettings::read(const sylph::YamlMap& yaml) {
  DemonstrationSettings settings;
  const auto count = [&](const std::string& key, int otherwise) {
    return static_cast<int>(yaml.integer(key, otherwise, 1, 1000000));
  };
  settings.first_solution_s =
      yaml.number("first_solution_s", settings.first_solution_s, sylph::Range::positive());
  settings.improvement_s =
      yaml.number("improvement_s", settings.improvement_s, sylph::Range::positive());
  settings.samples_per_world = count("samples_per_world", settings.samples_per_world);
  settings.samples_per_scene = count("samples_per_scene", settings.samples_per_scene);
  settings.rest_share = yaml.number("rest_share", settings.rest_share, {0.0, 1.0});
  settings.only_ties = yaml.boolean("only_ties", settings.only_ties);
  yaml.refuseUnread();
  return settings;
}

double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  constexpr double kNanosecond = 1e-9;
  return static_cast<double>(now.tv_sec) + kNanosecond * static_cast<double>(now.tv_nsec);
}

std::optional<std::vector<sylph::Vertices>> findExpertPlan(const sylph::SearchProblem& problem,
                                                           const DemonstrationSettings& settings,
                                                           sylph::Rng& rng) {
  sylph::FirstSolution first =
      sylph::findFirstSolution(problem, sylph::makeDistanceGenerator,
                               sylph::Deadline(settings.first_solution_s, processorTime), rng);
  if (first.status != sylph::Lacam::Status::Solved) {
    return std::nullopt;
  }
  constexpr int kThreads = 1;
  return sylph::improve(problem, std::move(first.plan), sylph::makeDistanceGenerator, kThreads,
                        sylph::Deadline(settings.improvement_s, processorTime), rng)
      .plan;
}

void addScenes(const sylph::Instance& instance, const sylph::SearchProblem& problem,
               const Demonstration& demonstration, int samples,
               const DemonstrationSettings& settings, sylph::Rng& rng, SceneStore& store) {
  const std::size_t steps =
      std::min(demonstration.plan.size() - 1, static_cast<std::size_t>(demonstration.steps));
  if (steps == 0) {
    return;
  }
  SceneMaker maker(instance, problem, demonstration, settings, rng);
  std::vector<std::size_t> timesteps(steps);
  std::iota(timesteps.begin(), timesteps.end(), std::size_t{0});
  // Neighbouring timesteps look alike: scenes from all over the plan teach more.
  sylph::shuffle(timesteps, rng);
  const std::size_t enough = store.sampleCount() + static_cast<std::size_t>(samples);
  for (const std::size_t timestep : timesteps) {
    if (store.sampleCount() >= enough) {
      break;
    }
    const Scene scene = maker.make(timestep);
    if (!scene.samples.empty()) {
      store.add(scene);
    }
  }
}

}  // namespace sylph_training
