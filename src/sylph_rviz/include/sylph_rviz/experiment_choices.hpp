#pragma once

#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"

namespace sylph_rviz {

/// An experiment that an operator may run in a lab.
struct ExperimentChoice {
  std::string name;     ///< file stem
  std::string path;     ///< absolute
  std::string refusal;  ///< why it does not fit the lab; empty: it does

  bool operator==(const ExperimentChoice& other) const {
    return path == other.path && refusal == other.refusal;
  }
};

/// Why an experiment cannot be run where the nodes serve `lab`: they turn cells into metres by the
/// lab's map and know the lab's robots only. Empty: it can.
std::string refusalOf(const sylph::Experiment& experiment, const sylph::Experiment& lab);

/// The experiment files in the folder of the lab's, by name, with the lab's own first. A file that
/// is not an experiment is left out.
/// @throws std::runtime_error if the lab's own cannot be read
std::vector<ExperimentChoice> experimentChoices(const std::string& lab_path);

}  // namespace sylph_rviz
