#pragma once

#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/planners/generator_factory.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/graph.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// What LaCAM with restarts came to.
struct FirstSolution {
  Lacam::Status status = Lacam::Status::Unfinished;  ///< Exhausted: there is no solution
  std::vector<Vertices> plan;  ///< the solution, or the way to the nearest configuration found
  long nodes = 0;              ///< configurations generated
};

/// LaCAM with restarts: depth-first search finds most solutions at once, and where it does not,
/// another order of the agents mostly does. Each attempt may take half as many steps again as the
/// one before, so that in the end one attempt sees everything: the whole is as complete as LaCAM.
FirstSolution findFirstSolution(const SearchProblem& problem,
                                const GeneratorFactory& make_generator, const Deadline& deadline,
                                Rng& rng);

}  // namespace sylph
