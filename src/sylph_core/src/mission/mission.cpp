#include "sylph_core/mission/mission.hpp"

#include <utility>

namespace sylph {

Mission toMission(const Experiment& experiment, std::shared_ptr<const Policy> policy) {
  Mission mission;
  mission.map_path = experiment.map_path;
  mission.grid = experiment.grid;
  mission.cell_size_m = experiment.cell_size_m;
  mission.corner = experiment.corner;
  mission.robots = namesOf(experiment);
  mission.goals = toInstance(experiment).goals;
  mission.planner = experiment.planning.planner;
  mission.policy = std::move(policy);
  mission.time_limit_s = experiment.planning.time_limit_s;
  mission.seed = experiment.seed;
  return mission;
}

}  // namespace sylph
