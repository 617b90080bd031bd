#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/policy/observation.hpp"
#include "sylph_training/imitation/regrets.hpp"

namespace sylph_training {

/// A view of sylph::ObservationEncoder in a word per cell: a bit for each binary channel, then five
/// bits of eight times the cost to go plus eight, then a byte for each of the two gaps of SVO,
/// which it holds to 1 / 127. The rest is without loss.
using PackedView = std::array<std::uint64_t, sylph::kViewCells>;

/// @param view  kObservationSize floats as encode() fills them
PackedView packView(const float* view);

/// @param view  out: kObservationSize floats, the channels of a cell side by side
void unpackView(const PackedView& view, float* out);

/// What one agent sees and what it should do.
struct Sample {
  std::uint16_t agent = 0;     ///< row in its scene
  std::uint8_t action = 0;     ///< the expert's, or the teacher's most frequent one
  std::uint8_t only_ties = 0;  ///< 1: tells the policy only of moves that come closer
  Regrets regrets{};           ///< the expert's, see Regrets
  std::array<std::uint8_t, sylph::kActionCount> votes{};  ///< of the teacher's draws; 0 if expert's
  PackedView view{};                                      ///< what it sees
};

/// What communication needs of an agent, whether it is a sample or not.
struct SceneAgent {
  std::array<float, sylph::kVectorSize> vector{};  ///< entries of the observation's vector
  std::uint16_t partner = 0;       ///< row in the scene; an agent without partner is its own
  std::uint16_t svo_centideg = 0;  ///< SVO as all see it [deg / 100]
};

/// @param svo_deg  0 ... 45 [deg]
std::uint16_t toCentidegrees(float svo_deg);

/// One joint configuration: all of its agents and some of them as samples.
struct Scene {
  std::vector<SceneAgent> agents;  ///< all of the configuration
  std::vector<Sample> samples;     ///< of some of them
};

/// Scenes in memory and in files.
///
/// A file holds the format's name, the numbers of scenes, agents and samples, the agents and the
/// samples of each scene, then all agents and all samples as they lie in memory: it is meant for
/// the computer, or the kind of computer, that wrote it.
class SceneStore {
 public:
  void add(const Scene& scene);

  /// Joint configurations.
  std::size_t sceneCount() const { return scenes_.size(); }
  /// Of all scenes.
  std::size_t sampleCount() const { return samples_.size(); }

  /// A range of the store's agents or samples.
  template <typename T>
  struct Span {
    const T* first;
    std::size_t count;
    const T* begin() const { return first; }
    const T* end() const { return first + count; }
    const T& operator[](std::size_t index) const { return first[index]; }
  };
  Span<SceneAgent> agents(std::size_t scene) const;
  Span<Sample> samples(std::size_t scene) const;

  /// Writes beside the place and renames, so that no reader ever sees a half.
  /// @throws std::runtime_error naming the file if it cannot be written
  void save(const std::string& path) const;

  /// Adds the scenes of a file.
  /// @throws std::runtime_error naming the file if it is not whole
  void load(const std::string& path);

 private:
  struct Range {
    std::uint64_t first_agent, agents, first_sample, samples;
  };

  std::vector<Range> scenes_;
  std::vector<SceneAgent> agents_;
  std::vector<Sample> samples_;
};

}  // namespace sylph_training
