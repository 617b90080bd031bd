#include "sylph_training/phase.hpp"

#include "sylph_training/imitation_phase.hpp"

namespace sylph_training {

std::unique_ptr<Phase> makePhase(const sylph::YamlMap& yaml, RunState& state) {
  yaml.word("kind", {"imitation", "dagger"}, yaml.text("kind"));
  return std::make_unique<ImitationPhase>(ImitationSettings::read(yaml), state);
}

}  // namespace sylph_training
