// Apart from makePlanner(): what reads files needs the names and links none of the planners.

#include "sylph_core/planners/planner.hpp"

namespace sylph {

const std::vector<std::string>& plannerNames() {
  static const std::vector<std::string> kNames = {"lacam", "pibt", "sylph", "sylph_pibt",
                                                  "sylph_lacam"};
  return kNames;
}

const std::vector<std::string>& ablationNames() {
  static const std::vector<std::string> kNames = {"random_tie_breaking", "svo_by_priority",
                                                  "random_svo_per_step", "random_svo_per_episode",
                                                  "random_svo_per_partner"};
  return kNames;
}

}  // namespace sylph
