#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_rehearsal/rehearsal.hpp"

namespace sylph_rehearsal {

/// A number that tells of runs.
struct Figure {
  const char* name;  ///< with its unit
  /// Every value that a run has: none, one, or one for each of its robots' brakings.
  std::function<std::vector<double>(const Rehearsal&)> of;
};

/// Of a run as a whole.
std::vector<Figure> runFigures();
/// Of the robots that an emergency stop found driving.
std::vector<Figure> brakingFigures();
/// Values of all runs, ascending.
std::vector<double> sortedValues(const Figure& figure, const std::vector<Rehearsal>& runs);
/// The value below which a share of all lies, by the nearest rank.
/// @param sorted  ascending, not empty
double quantile(const std::vector<double>& sorted, double share);

using EndingCounts = std::map<Ending, int>;
/// How many runs ended how.
EndingCounts countEndings(const std::vector<Rehearsal>& runs);
/// How runs ended, by each kind of fault that they had.
std::map<std::string, EndingCounts> countByFault(const std::vector<Rehearsal>& runs);
/// Violated, stopped, finished.
std::vector<std::reference_wrapper<const Rehearsal>> worstFirst(const std::vector<Rehearsal>& runs);
/// "robot_1 for robot_2" and the seconds a run that this took, the longest first.
std::vector<std::pair<std::string, double>> longestWaits(const sylph::Experiment& experiment,
                                                         const std::vector<Rehearsal>& runs);

}  // namespace sylph_rehearsal
