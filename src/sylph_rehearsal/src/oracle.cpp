#include "oracle.hpp"

namespace sylph_rehearsal {

void Oracle::check(const sylph_sim::Simulation& simulation, double time_s) {
  if (simulation.collisions() > collisions_) {
    collisions_ = simulation.collisions();
    violations_.push_back({time_s, "two robots touch"});
  }
  if (simulation.obstacleEntries() > obstacle_entries_) {
    obstacle_entries_ = simulation.obstacleEntries();
    violations_.push_back({time_s, "a robot enters an obstacle"});
  }
}

}  // namespace sylph_rehearsal
