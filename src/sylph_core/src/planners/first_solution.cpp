#include "sylph_core/planners/first_solution.hpp"

namespace sylph {

FirstSolution findFirstSolution(const SearchProblem& problem,
                                const GeneratorFactory& make_generator, const Deadline& deadline,
                                Rng& rng) {
  FirstSolution solution;
  long max_steps = 1000;
  for (int attempt = 0; attempt == 0 || !deadline.isOver(); ++attempt) {
    const auto generator = make_generator(problem, attempt, rng);
    Lacam lacam(problem, *generator, rng);
    solution.status = lacam.search(deadline, max_steps);
    solution.plan = lacam.plan();
    solution.nodes += lacam.nodeCount();
    if (solution.status != Lacam::Status::Unfinished) {
      break;
    }
    // Longer each time: who needs more steps than the first attempt had must get them some day.
    max_steps += max_steps / 2;
  }
  return solution;
}

}  // namespace sylph
