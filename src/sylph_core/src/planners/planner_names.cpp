// Apart from makePlanner(): what reads files needs the names and links none of the planners.

#include "sylph_core/planners/planner.hpp"

namespace sylph {

const std::vector<std::string>& plannerNames() {
  static const std::vector<std::string> kNames = {"lacam", "pibt", "sylph", "sylph_pibt",
                                                  "sylph_lacam"};
  return kNames;
}

}  // namespace sylph
