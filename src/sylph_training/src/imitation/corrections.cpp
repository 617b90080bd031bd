#include "sylph_training/imitation/corrections.hpp"

#include <utility>

#include "sylph_core/planners/planner.hpp"

namespace sylph_training {
namespace {

constexpr char kLeader[] = "sylph_pibt";
constexpr double kLongestLead_s = 60.0;

std::size_t drawGap(const Interval& interval, sylph::Rng& rng) {
  const auto choices = static_cast<std::size_t>(interval.highest - interval.lowest) + 1;
  return static_cast<std::size_t>(interval.lowest) + sylph::drawIndex(rng, choices);
}

std::vector<sylph::Action> movesInto(const sylph::Plan& plan, std::size_t timestep) {
  std::vector<sylph::Action> moves;
  for (std::size_t agent = 0; agent < plan[timestep].size(); ++agent) {
    moves.push_back(sylph::actionBetween(plan[timestep - 1][agent], plan[timestep][agent]).value());
  }
  return moves;
}

}  // namespace

CorrectionSettings CorrectionSettings::read(const sylph::YamlMap& yaml) {
  CorrectionSettings settings;
  const auto count = [&](const std::string& key, int& value) {
    value = static_cast<int>(yaml.integer(key, value, 1, 1000000));
  };
  count("round", settings.round);
  count("shards", settings.shards);
  count("worlds_per_shard", settings.worlds_per_shard);
  count("most_steps", settings.most_steps);
  count("steps", settings.steps);
  count("samples", settings.samples);
  settings.share = yaml.number("share", settings.share, {0.0, 1.0});
  settings.improvement_s =
      yaml.number("improvement_s", settings.improvement_s, sylph::Range::positive());
  if (yaml.has("every")) {
    const std::vector<int> bounds = yaml.integers("every", 1, 1000000);
    if (bounds.size() != 2 || bounds[0] > bounds[1]) {
      throw yaml.error("every", "must be [lowest, highest]");
    }
    settings.every = {static_cast<double>(bounds[0]), static_cast<double>(bounds[1])};
  }
  yaml.refuseUnread();
  return settings;
}

SceneSource correctedScenes(std::shared_ptr<const sylph::Policy> policy,
                            const CorrectionSettings& settings,
                            const DemonstrationSettings& demonstrations) {
  const std::shared_ptr<const sylph::Planner> leader =
      sylph::makePlanner(kLeader, std::move(policy));
  DemonstrationSettings labels = demonstrations;
  labels.improvement_s = settings.improvement_s;
  return [leader, settings, labels](const sylph::Instance& instance, sylph::Rng& rng,
                                    SceneStore& store) {
    sylph::PlanningLimits limits;
    limits.time_limit_s = kLongestLead_s;
    limits.max_steps = settings.most_steps;
    const sylph::Plan led = leader->plan(instance, limits, rng).plan;
    const std::size_t samples_before = store.sampleCount();
    for (std::size_t timestep = drawGap(settings.every, rng); timestep + 1 < led.size();
         timestep += drawGap(settings.every, rng)) {
      sylph::Instance from_here = instance;
      from_here.starts = led[timestep];
      const sylph::SearchProblem problem(from_here);
      auto plan = findExpertPlan(problem, labels, rng);
      if (plan) {
        addScenes(from_here, problem, {std::move(*plan), movesInto(led, timestep), settings.steps},
                  settings.samples, labels, rng, store);
      }
    }
    return store.sampleCount() > samples_before;
  };
}

}  // namespace sylph_training
