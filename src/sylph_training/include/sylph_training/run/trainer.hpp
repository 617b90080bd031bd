#pragma once

#include <atomic>
#include <string>

#include "sylph_training/run/phase.hpp"

namespace sylph_training {

/// Runs the phases of a configuration one after the other in a run's folder:
///
/// - `checkpoint.pt`: everything the run depends on, every few minutes and at the end. Written
///   beside its place and renamed, so that a run which is killed at any time goes on from the last
///   one.
/// - `weights.safetensors`: the averaged weights of that moment for sylph::Network.
/// - `log_<n>_<kind>.csv`: the figures of phase n, one line every few steps.
class Trainer {
 public:
  /// @param resume        go on from the folder's checkpoint
  /// @param weights_path  weights to begin with instead of random ones; empty: none
  /// @throws std::runtime_error with one line if there is a checkpoint but `resume` is not set, if
  /// it is set and there is none, or if the configuration or the checkpoint is malformed
  Trainer(TrainingSettings settings, std::string folder, bool resume,
          const std::string& weights_path = "");

  /// Trains until all phases are done, or until `stop` is set: then it writes a checkpoint first.
  /// @return whether all phases are done
  bool run(const std::atomic<bool>& stop);

 private:
  class Log;

  bool runPhase(std::size_t phase, const std::atomic<bool>& stop);
  void saveCheckpoint(std::size_t phase_index, long step, const Phase& phase);
  std::string path(const std::string& name) const { return state_.folder + "/" + name; }

  RunState state_;
  std::size_t first_phase_ = 0;
  long first_step_ = 0;
  bool is_resumed_ = false;
};

}  // namespace sylph_training
