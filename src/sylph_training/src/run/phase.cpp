#include "sylph_training/run/phase.hpp"

#include "sylph_training/imitation/imitation_phase.hpp"
#include "sylph_training/smp3o/smp3o_phase.hpp"

namespace sylph_training {

std::unique_ptr<Phase> makePhase(const sylph::YamlMap& yaml, RunState& state) {
  const std::string kind = yaml.word("kind", {"imitation", "smp3o"}, yaml.text("kind"));
  if (kind == "smp3o") {
    return std::make_unique<Smp3oPhase>(Smp3oSettings::read(yaml), state);
  }
  return std::make_unique<ImitationPhase>(ImitationSettings::read(yaml), state);
}

}  // namespace sylph_training
