#include "sylph_training/imitation/reactive_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sylph_core/policy/policy_rollout.hpp"
#include "sylph_core/social/partners.hpp"
#include "sylph_core/social/svo.hpp"
#include "sylph_training/imitation/reactive_teacher.hpp"
#include "sylph_training/imitation/team_state.hpp"

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::AgentId;

constexpr double kPerturbedAgents = 0.5;  // of a scene with other SVOs
constexpr double kMostNoise = 0.02;       // of the moves where the teacher leads are any
constexpr double kLowestTemperature = 0.3;
constexpr double kHighestTemperature = 1.0;

std::vector<float> drawTieBreaks(std::size_t count, sylph::Rng& rng) {
  std::vector<float> tie_breaks;
  for (std::size_t agent = 0; agent < count; ++agent) {
    tie_breaks.push_back(static_cast<float>(sylph::drawFraction(rng)));
  }
  return tie_breaks;
}

Action drawAction(const TeamState& team, AgentId agent, bool greedy, sylph::Rng& rng) {
  std::vector<Action> choices;
  for (const Action action : sylph::kActions) {
    if (greedy ? team.isGreedy(agent, action) : team.isValid(agent, action)) {
      choices.push_back(action);
    }
  }
  return choices[sylph::drawIndex(rng, choices.size())];
}

/// Turns configurations of one world into scenes.
class Labeller {
 public:
  Labeller(const TeamState& team, const ReactiveSettings& settings, sylph::Rng& rng)
      : team_(&team),
        settings_(&settings),
        rng_(&rng),
        teacher_(team.problem(), rng),
        encoder_(team.instance().grid, team.problem().distances.fields()) {}

  ReactiveTeacher& teacher() { return teacher_; }

  /// @param logits  that the teacher's taste is to follow, nullptr: its own
  Scene make(const std::vector<AgentId>& partners, const sylph::AgentRows* logits) {
    sylph::AgentStates states = team_->states();
    if (sylph::drawFraction(*rng_) < settings_->perturbed) {
      perturb(states.svo_deg);
    }
    encoder_.setStates(states);
    const std::vector<Votes> votes = vote(states.svo_deg, logits);
    const std::vector<bool> is_sample = drawSamples(votes);
    Scene scene;
    std::vector<float> view(sylph::kObservationSize);
    for (AgentId agent = 0; agent < team_->agentCount(); ++agent) {
      const auto index = static_cast<std::size_t>(agent);
      SceneAgent known;
      known.partner = static_cast<std::uint16_t>(partners[index]);
      known.svo_centideg = toCentidegrees(states.svo_deg[index]);
      encoder_.encode(agent, view.data(), known.vector.data());
      scene.agents.push_back(known);
      if (is_sample[index]) {
        scene.samples.push_back(sampleOf(agent, votes[index], view.data()));
      }
    }
    return scene;
  }

 private:
  using Votes = std::array<std::uint8_t, sylph::kActionCount>;

  void perturb(std::vector<float>& svo_deg) {
    for (AgentId agent = 0; agent < team_->agentCount(); ++agent) {
      if (!team_->isHome(agent) && sylph::drawFraction(*rng_) < kPerturbedAgents) {
        svo_deg[static_cast<std::size_t>(agent)] = static_cast<float>(
            sylph::svoOfLevel(sylph::kMostProsocialLevel) * sylph::drawFraction(*rng_));
      }
    }
  }

  std::vector<Votes> vote(const std::vector<float>& svo_deg, const sylph::AgentRows* logits) {
    std::vector<Votes> votes(svo_deg.size(), Votes{});
    for (int draw = 0; draw < settings_->draws; ++draw) {
      const std::vector<Action> desired = teacher_.desiredActions(*team_, svo_deg, logits);
      for (std::size_t agent = 0; agent < desired.size(); ++agent) {
        ++votes[agent][static_cast<std::size_t>(desired[agent])];
      }
    }
    return votes;
  }

  static Action favourite(const Votes& votes) {
    return static_cast<Action>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }

  // Agents at rest and agents that just go on are many and teach little.
  std::vector<bool> drawSamples(const std::vector<Votes>& votes) {
    std::vector<std::size_t> drawn;
    for (AgentId agent = 0; agent < team_->agentCount(); ++agent) {
      const Action desired = favourite(votes[static_cast<std::size_t>(agent)]);
      const bool rests = team_->isHome(agent) && desired == Action::Stay;
      const double share = rests                             ? settings_->rest_share
                           : team_->isGreedy(agent, desired) ? settings_->greedy_share
                                                             : 1.0;
      if (sylph::drawFraction(*rng_) < share) {
        drawn.push_back(static_cast<std::size_t>(agent));
      }
    }
    sylph::shuffle(drawn, *rng_);
    drawn.resize(std::min(drawn.size(), static_cast<std::size_t>(settings_->samples_per_scene)));
    std::vector<bool> is_sample(votes.size(), false);
    for (const std::size_t agent : drawn) {
      is_sample[agent] = true;
    }
    return is_sample;
  }

  Sample sampleOf(AgentId agent, const Votes& votes, const float* view) const {
    Sample sample;
    sample.agent = static_cast<std::uint16_t>(agent);
    sample.action = static_cast<std::uint8_t>(favourite(votes));
    sample.votes = votes;
    for (const Action action : sylph::kActions) {
      sample.regrets[static_cast<std::size_t>(action)] =
          !team_->isValid(agent, action)                ? kImpossible
          : votes[static_cast<std::size_t>(action)] > 0 ? std::uint8_t{0}
                                                        : std::uint8_t{1};
    }
    sample.view = packView(view);
    return sample;
  }

  const TeamState* team_;
  const ReactiveSettings* settings_;
  sylph::Rng* rng_;
  ReactiveTeacher teacher_;
  sylph::ObservationEncoder encoder_;
};

/// The teacher's desired actions, less some that give way, with a little noise.
std::vector<Action> withMistakes(std::vector<Action> desired, const TeamState& team,
                                 double mistakes, double noise, sylph::Rng& rng) {
  for (AgentId agent = 0; agent < team.agentCount(); ++agent) {
    Action& action = desired[static_cast<std::size_t>(agent)];
    if (!team.isGreedy(agent, action) && sylph::drawFraction(rng) < mistakes) {
      action = drawAction(team, agent, true, rng);
    }
    if (sylph::drawFraction(rng) < noise) {
      action = drawAction(team, agent, false, rng);
    }
  }
  return desired;
}

/// Chance that a timestep becomes a scene: such that a team on its way gives about
/// samples_per_world, and one that is still not there after half of the time, and so may be stuck,
/// gives all it can.
double sceneShare(const ReactiveSettings& settings, int agents, int step) {
  constexpr double kSampled = 0.4;  // of a team, about
  if (step > settings.most_steps / 2) {
    return 1.0;
  }
  return std::min(settings.scene_share,
                  settings.samples_per_world / (kSampled * agents * settings.most_steps));
}

void addIfAny(const Scene& scene, SceneStore& store) {
  if (!scene.samples.empty()) {
    store.add(scene);
  }
}

}  // namespace

ReactiveSettings ReactiveSettings::read(const sylph::YamlMap& yaml) {
  ReactiveSettings settings;
  const auto count = [&](const std::string& key, int& value) {
    value = static_cast<int>(yaml.integer(key, value, 1, 1000000));
  };
  const auto share = [&](const std::string& key, double& value) {
    value = yaml.number(key, value, {0.0, 1.0});
  };
  share("share", settings.share);
  count("teacher_shards", settings.teacher_shards);
  count("student_steps", settings.student_steps);
  share("student_share", settings.student_share);
  count("worlds_per_shard", settings.worlds_per_shard);
  count("most_agents", settings.most_agents);
  count("most_steps", settings.most_steps);
  count("samples_per_world", settings.samples_per_world);
  count("samples_per_scene", settings.samples_per_scene);
  settings.scene_share = yaml.number("scene_share", settings.scene_share, {0.0, 1.0, true});
  share("rest_share", settings.rest_share);
  share("greedy_share", settings.greedy_share);
  settings.draws = static_cast<int>(yaml.integer("draws", settings.draws, 1, 255));
  share("mistakes", settings.mistakes);
  share("perturbed", settings.perturbed);
  settings.by_preference = yaml.boolean("by_preference", settings.by_preference);
  yaml.refuseUnread();
  return settings;
}

SceneSource teacherLedScenes(const ReactiveSettings& settings) {
  return [settings](const sylph::Instance& instance, sylph::Rng& rng, SceneStore& store) {
    const sylph::SearchProblem problem(instance);
    TeamState team(instance, problem, drawTieBreaks(instance.starts.size(), rng));
    Labeller labeller(team, settings, rng);
    const auto distance = [&](AgentId agent, const sylph::Cell& cell) {
      return problem.distances.fields()[static_cast<std::size_t>(agent)].at(cell);
    };
    sylph::Partners partners(instance.grid, distance, instance.starts);
    const double mistakes = settings.mistakes * sylph::drawFraction(rng);
    const double noise = kMostNoise * sylph::drawFraction(rng);
    const std::size_t before = store.sampleCount();
    for (int step = 0; step < settings.most_steps && !team.isSolved(); ++step) {
      if (step > 0) {
        partners.update(team.states().cells);
      }
      if (sylph::drawFraction(rng) < sceneShare(settings, instance.agentCount(), step)) {
        addIfAny(labeller.make(partners.fixed(), nullptr), store);
      }
      const std::vector<float> svo_deg = team.states().svo_deg;
      team.move(withMistakes(labeller.teacher().desiredActions(team, svo_deg), team, mistakes,
                             noise, rng),
                svo_deg);
    }
    return store.sampleCount() > before;
  };
}

SceneSource studentLedScenes(std::shared_ptr<const sylph::Policy> policy,
                             const ReactiveSettings& settings) {
  return [policy = std::move(policy), settings](const sylph::Instance& instance, sylph::Rng& rng,
                                                SceneStore& store) {
    if (instance.agentCount() > settings.most_agents) {
      return false;
    }
    const sylph::SearchProblem problem(instance);
    sylph::PolicyRollout rollout(*policy, instance.grid, problem.distances.fields(),
                                 sylph::SvoChoice::Priority, 1, rng);
    TeamState team(instance, problem, rollout.tieBreaks());
    Labeller labeller(team, settings, rng);
    sylph::PolicyStep step = rollout.nothingKnown();
    const double temperature =
        kLowestTemperature + (kHighestTemperature - kLowestTemperature) * sylph::drawFraction(rng);
    const std::size_t before = store.sampleCount();
    for (int timestep = 0; timestep < settings.most_steps && !team.isSolved(); ++timestep) {
      step = rollout.follow(step, team.before(), team.states().cells, rng);
      if (sylph::drawFraction(rng) < sceneShare(settings, instance.agentCount(), timestep)) {
        addIfAny(
            labeller.make(step.social.partners, settings.by_preference ? &step.actions : nullptr),
            store);
      }
      team.move(drawDesiredActions(team, step.actions, temperature, rng), team.states().svo_deg);
    }
    return store.sampleCount() > before;
  };
}

std::vector<Action> drawDesiredActions(const TeamState& team, const sylph::AgentRows& logits,
                                       double temperature, sylph::Rng& rng) {
  std::vector<Action> desired;
  for (AgentId agent = 0; agent < team.agentCount(); ++agent) {
    double best = 0.0;
    Action drawn = Action::Stay;
    for (const Action action : sylph::kActions) {
      const double key = static_cast<double>(logits(agent, static_cast<Eigen::Index>(action))) +
                         temperature * sylph::drawGumbel(rng);
      if (action == Action::Stay || (team.isValid(agent, action) && key > best)) {
        best = key;
        drawn = action;
      }
    }
    desired.push_back(drawn);
  }
  return desired;
}

}  // namespace sylph_training
