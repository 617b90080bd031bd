#include "sylph_training/run/policy_meters.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/social/precedence.hpp"
#include "sylph_core/social/svo.hpp"
#include "sylph_training/imitation/reactive_scenes.hpp"
#include "sylph_training/imitation/reactive_teacher.hpp"
#include "sylph_training/imitation/team_state.hpp"

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::AgentId;

constexpr int kSide = 32;                // [cells]
constexpr int kSensitivityInterval = 8;  // [timesteps]
constexpr int kLongestMeeting = 3;       // [timesteps] between two decisions of a pair
constexpr float kSelfish_deg = 0.F;

constexpr auto kProsocial_deg =
    static_cast<float>(sylph::kSvoLevelSpacingDeg * sylph::kMostProsocialLevel);

sylph::Instance makeWorld(const MeterWorlds& worlds, sylph::Rng& rng) {
  switch (worlds.family) {
    case MeterWorlds::Family::Random:
      return randomInstance(sylph::randomMap({kSide, kSide, 0.2}, rng), worlds.agents, {}, rng);
    case MeterWorlds::Family::Room:
      return randomInstance(sylph::roomMap({kSide, kSide, 3, 1, 0.9}, rng), worlds.agents, {}, rng);
    case MeterWorlds::Family::Maze:
      break;
  }
  return randomInstance(sylph::mazeMap({kSide, kSide, 1, 0.1}, rng), worlds.agents, {}, rng);
}

/// A share that grows by decisions.
class Share {
 public:
  void add(bool is_hit) {
    ++count_;
    hits_ += is_hit ? 1 : 0;
  }
  double value() const {
    return count_ == 0 ? 0.0 : static_cast<double>(hits_) / static_cast<double>(count_);
  }
  long count() const { return count_; }

 private:
  long count_ = 0;
  long hits_ = 0;
};

class Mean {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
  }
  double value() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
  long count() const { return count_; }

 private:
  long count_ = 0;
  double sum_ = 0.0;
};

struct Tally {
  int solved = 0;
  Mean arrived, cost_ratio, svo_sensitivity, svo_error_deg;
  Share non_greedy, recall, exact_recall, teacher_repeat, precision, away_recall, away_precision;
  Share role_flips, gives_way_by_svo;
};

bool isAway(const TeamState& team, AgentId agent, Action action) {
  return action != Action::Stay && !team.isGreedy(agent, action);
}

/// Plays one world and adds to the tally.
class Meter {
 public:
  Meter(const sylph::Policy& policy, sylph::Instance instance, const MeterSettings& settings,
        sylph::Rng& rng, Tally& tally)
      : instance_(std::move(instance)),
        settings_(&settings),
        rng_(&rng),
        tally_(&tally),
        problem_(instance_),
        rollout_(policy, instance_.grid, problem_.distances.fields(), settings.svo, 1, rng),
        probe_(policy, instance_.grid, problem_.distances.fields(), sylph::SvoChoice::Mean, 1, rng),
        team_(instance_, problem_, rollout_.tieBreaks()),
        teacher_(problem_, rng) {}

  void play() {
    sylph::PolicyStep before = rollout_.nothingKnown();
    sylph::Plan plan = {instance_.starts};
    for (int timestep = 0; timestep < settings_->steps && !team_.isSolved(); ++timestep) {
      sylph::PolicyStep step = rollout_.follow(before, team_.before(), team_.states().cells, *rng_);
      const auto desired = drawDesiredActions(team_, step.actions, settings_->temperature, *rng_);
      const std::vector<float>& svo_deg = step.social.svo_deg;
      compare(desired, teacher_.desiredActions(team_, svo_deg),
              teacher_.desiredActions(team_, svo_deg));
      watchRoles(timestep, desired, svo_deg);
      for (std::size_t agent = 0; agent < svo_deg.size(); ++agent) {
        tally_->svo_error_deg.add(std::abs(svo_deg[agent] - team_.states().svo_deg[agent]));
      }
      if (timestep % kSensitivityInterval == kSensitivityInterval / 2) {
        probeSvo(before);
      }
      team_.move(desired, svo_deg);
      plan.push_back(team_.states().cells);
      before = std::move(step);
    }
    int home = 0;
    for (AgentId agent = 0; agent < team_.agentCount(); ++agent) {
      home += team_.isHome(agent) ? 1 : 0;
    }
    tally_->arrived.add(static_cast<double>(home) / team_.agentCount());
    if (team_.isSolved()) {
      ++tally_->solved;
      tally_->cost_ratio.add(
          static_cast<double>(computeMetrics(instance_, plan).sum_of_costs) /
          static_cast<double>(std::max(sylph::sumOfCostsLowerBound(instance_), 1L)));
    }
  }

 private:
  void compare(const std::vector<Action>& desired, const std::vector<Action>& taught,
               const std::vector<Action>& taught_again) {
    for (AgentId agent = 0; agent < team_.agentCount(); ++agent) {
      const auto index = static_cast<std::size_t>(agent);
      const Action action = desired[index];
      const Action right = taught[index];
      if (team_.isHome(agent) && right == Action::Stay) {
        continue;
      }
      const bool is_right_way = !team_.isGreedy(agent, right);
      const bool gives_way = !team_.isGreedy(agent, action);
      tally_->non_greedy.add(is_right_way);
      if (is_right_way) {
        tally_->recall.add(gives_way);
        tally_->exact_recall.add(action == right);
        tally_->teacher_repeat.add(taught_again[index] == right);
      }
      if (gives_way) {
        tally_->precision.add(is_right_way);
      }
      if (isAway(team_, agent, right)) {
        tally_->away_recall.add(isAway(team_, agent, action));
      }
      if (isAway(team_, agent, action)) {
        tally_->away_precision.add(isAway(team_, agent, right));
      }
    }
  }

  // Pairs of adjacent agents of which each could come closer to its goal by entering the other's
  // cell. They have roles if one of them means to and the other does not.
  void watchRoles(int timestep, const std::vector<Action>& desired,
                  const std::vector<float>& svo_deg) {
    const sylph::Vertices at = problem_.graph.toVertices(team_.states().cells);
    std::map<sylph::VertexId, AgentId> occupants;
    for (AgentId agent = 0; agent < team_.agentCount(); ++agent) {
      occupants[at[static_cast<std::size_t>(agent)]] = agent;
    }
    for (AgentId agent = 0; agent < team_.agentCount(); ++agent) {
      const auto index = static_cast<std::size_t>(agent);
      for (const Action action : {Action::East, Action::South}) {
        if (!team_.isValid(agent, action)) {
          continue;
        }
        const auto found =
            occupants.find(problem_.graph.vertexAt(neighbor(team_.states().cells[index], action)));
        if (found == occupants.end() || !team_.isGreedy(agent, action) ||
            !team_.isGreedy(found->second, action == Action::East ? Action::West : Action::North)) {
          continue;
        }
        const auto other = static_cast<std::size_t>(found->second);
        const bool pushes = team_.isGreedy(agent, desired[index]);
        if (pushes == team_.isGreedy(found->second, desired[other])) {
          continue;
        }
        if (svo_deg[index] != svo_deg[other]) {
          tally_->gives_way_by_svo.add(pushes == (svo_deg[index] < svo_deg[other]));
        }
        const std::pair<AgentId, AgentId> pair = std::minmax(agent, found->second);
        const bool first_pushes = pushes == (agent == pair.first);
        const auto known = roles_.find(pair);
        if (known != roles_.end() && timestep - known->second.first <= kLongestMeeting) {
          tally_->role_flips.add(known->second.second != first_pushes);
        }
        roles_[pair] = {timestep, first_pushes};
      }
    }
  }

  void probeSvo(const sylph::PolicyStep& before) {
    std::vector<bool> is_used(static_cast<std::size_t>(team_.agentCount()), false);
    sylph::PolicyStep one_way = before;
    sylph::PolicyStep other_way = before;
    std::vector<AgentId> probed;
    const auto set = [](sylph::PolicyStep& step, AgentId agent, float svo_deg) {
      step.social.svo_deg[static_cast<std::size_t>(agent)] = svo_deg;
      sylph::spreadOverLevels(svo_deg, step.svo.row(agent).data());
    };
    for (AgentId agent = 0; agent < team_.agentCount(); ++agent) {
      for (AgentId other = agent + 1; other < team_.agentCount(); ++other) {
        const auto first = static_cast<std::size_t>(agent);
        const auto second = static_cast<std::size_t>(other);
        if (is_used[first] || is_used[second] || team_.isHome(agent) || team_.isHome(other) ||
            !actionBetween(team_.states().cells[first], team_.states().cells[second])) {
          continue;
        }
        is_used[first] = is_used[second] = true;
        set(one_way, agent, kSelfish_deg);
        set(one_way, other, kProsocial_deg);
        set(other_way, agent, kProsocial_deg);
        set(other_way, other, kSelfish_deg);
        probed.insert(probed.end(), {agent, other});
      }
    }
    if (probed.empty()) {
      return;
    }
    const sylph::Configuration& from = team_.before();
    const sylph::Configuration& to = team_.states().cells;
    const sylph::AgentRows one = probe_.follow(one_way, from, to, *rng_).actions;
    const sylph::AgentRows other = probe_.follow(other_way, from, to, *rng_).actions;
    for (const AgentId agent : probed) {
      tally_->svo_sensitivity.add(
          (distribution(agent, one) - distribution(agent, other)).cwiseAbs().sum() / 2.0);
    }
  }

  Eigen::RowVectorXd distribution(AgentId agent, const sylph::AgentRows& logits) const {
    Eigen::RowVectorXd weights(sylph::kActionCount);
    const double highest = logits.row(agent).maxCoeff();
    for (const Action action : sylph::kActions) {
      const auto column = static_cast<Eigen::Index>(action);
      weights(column) = team_.isValid(agent, action)
                            ? std::exp((static_cast<double>(logits(agent, column)) - highest) /
                                       settings_->temperature)
                            : 0.0;
    }
    return weights / weights.sum();
  }

  sylph::Instance instance_;
  const MeterSettings* settings_;
  sylph::Rng* rng_;
  Tally* tally_;
  sylph::SearchProblem problem_;
  sylph::PolicyRollout rollout_;
  sylph::PolicyRollout probe_;  // asked with other SVOs
  TeamState team_;
  ReactiveTeacher teacher_;
  // Per pair: when it had roles last, and whether the first one pushed.
  std::map<std::pair<AgentId, AgentId>, std::pair<int, bool>> roles_;
};

}  // namespace

std::string MeterWorlds::name() const {
  const char* const family = this->family == Family::Random ? "random"
                             : this->family == Family::Room ? "room"
                                                            : "maze";
  return std::string(family) + "_" + std::to_string(agents);
}

const std::vector<MeterWorlds>& meterWorlds() {
  using Family = MeterWorlds::Family;
  static const std::vector<MeterWorlds> kWorlds = {
      {Family::Maze, 32}, {Family::Random, 200}, {Family::Room, 100}, {Family::Random, 100}};
  return kWorlds;
}

MeterSettings MeterSettings::read(const sylph::YamlMap& yaml) {
  MeterSettings settings;
  settings.worlds = static_cast<int>(yaml.integer("worlds", settings.worlds, 1, 10000));
  settings.steps = static_cast<int>(yaml.integer("steps", settings.steps, 1, 10000));
  settings.temperature = yaml.number("temperature", settings.temperature, sylph::Range::positive());
  yaml.refuseUnread();
  return settings;
}

Figures PolicyMeters::figures() const {
  return {{"solved", static_cast<double>(solved) / worlds},
          {"arrived", arrived},
          {"cost_ratio", cost_ratio},
          {"non_greedy", non_greedy},
          {"recall", recall},
          {"exact_recall", exact_recall},
          {"teacher_repeat", teacher_repeat},
          {"precision", precision},
          {"away_recall", away_recall},
          {"away_precision", away_precision},
          {"role_flips", role_flips},
          {"gives_way_by_svo", gives_way_by_svo},
          {"svo_sensitivity", svo_sensitivity},
          {"svo_error_deg", svo_error_deg}};
}

PolicyMeters measure(const sylph::Policy& policy, const MeterWorlds& worlds,
                     const MeterSettings& settings) {
  Tally tally;
  for (int world = 0; world < settings.worlds; ++world) {
    sylph::Rng rng(settings.seed + static_cast<std::uint32_t>(world));
    Meter(policy, makeWorld(worlds, rng), settings, rng, tally).play();
  }
  PolicyMeters meters;
  meters.worlds = settings.worlds;
  meters.solved = tally.solved;
  meters.arrived = tally.arrived.value();
  meters.cost_ratio = tally.cost_ratio.value();
  meters.non_greedy = tally.non_greedy.value();
  meters.recall = tally.recall.value();
  meters.exact_recall = tally.exact_recall.value();
  meters.teacher_repeat = tally.teacher_repeat.value();
  meters.precision = tally.precision.value();
  meters.away_recall = tally.away_recall.value();
  meters.away_precision = tally.away_precision.value();
  meters.role_flips = tally.role_flips.value();
  meters.gives_way_by_svo = tally.gives_way_by_svo.value();
  meters.svo_sensitivity = tally.svo_sensitivity.value();
  meters.svo_error_deg = tally.svo_error_deg.value();
  meters.head_on_roles = tally.gives_way_by_svo.count();
  meters.pairs = tally.svo_sensitivity.count();
  return meters;
}

}  // namespace sylph_training
