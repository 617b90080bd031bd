#include <gtest/gtest.h>

#include <filesystem>

#include "sylph_training/imitation/imitation_phase.hpp"
#include "sylph_training/smp3o/smp3o_phase.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph_training {
namespace {

/// What is wrong with a configuration, empty if nothing.
std::string errorOf(const std::string& text) {
  const sylph::TemporaryFolder folder;
  try {
    const auto settings = TrainingSettings::load(folder.write("config.yaml", text));
    for (const sylph::YamlMap& phase : settings.phases) {
      ImitationSettings::read(phase);
    }
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

void expectError(const std::string& text, const std::string& field) {
  EXPECT_NE(std::string::npos, errorOf(text).find(field)) << text << ": " << errorOf(text);
}

TEST(TrainingSettingsTest, MalformedFieldsAreNamed) {
  expectError("seed: 1\n", "phases");
  expectError("phases: []\n", "phases");
  expectError("phases: [{steps: 4}]\n", "phases[0].kind");
  expectError("phases: [{kind: imitation, stesp: 4}]\n", "stesp");
  expectError("phases: [{kind: imitation, precision: half}]\n", "phases[0].precision");
  expectError("phases: [{kind: imitation, learning_rate: 0}]\n", "phases[0].learning_rate");
  expectError("phases: [{kind: imitation, corrections: {}}]\n", "corrections");
  expectError("phases: [{kind: imitation, reactive: {share: 2}}]\n", "reactive.share");
  expectError("network: {width: 7}\nphases: [{kind: imitation}]\n", "network.width");
  expectError("worlds: {side: 10}\nphases: [{kind: imitation}]\n", "worlds.side");
  expectError("demonstrations: {improvement_s: -1}\nphases: [{kind: imitation}]\n",
              "demonstrations.improvement_s");
}

TEST(TrainingSettingsTest, ADeviceThatIsNotThereIsAnError) {
  expectError("device: tpu\nphases: [{kind: imitation}]\n", "device");
  EXPECT_EQ("", errorOf("device: cpu\nphases: [{kind: imitation}]\n"));
  if (!torch::cuda::is_available()) {
    expectError("device: cuda\nphases: [{kind: imitation}]\n", "device: is 'cuda'");
  }
}

TEST(TrainingSettingsTest, TheShippedConfigurationsAreSound) {
  for (const auto& entry : std::filesystem::directory_iterator("config")) {
    SCOPED_TRACE(entry.path());
    const auto settings = TrainingSettings::load(entry.path());
    ASSERT_FALSE(settings.phases.empty());
    for (const sylph::YamlMap& phase : settings.phases) {
      EXPECT_GT(phase.text("kind") == "smp3o" ? Smp3oSettings::read(phase).steps
                                              : ImitationSettings::read(phase).steps,
                0);
    }
  }
}

}  // namespace
}  // namespace sylph_training
