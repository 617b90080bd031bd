#include "sylph_training/worlds/world_sampler.hpp"

#include <gtest/gtest.h>

#include "test/support/temporary_folder.hpp"

namespace sylph_training {
namespace {

WorldSettings readText(const std::string& text) {
  const sylph::TemporaryFolder folder;
  return WorldSettings::read(sylph::YamlMap::load(folder.write("worlds.yaml", text)));
}

std::string errorOf(const std::string& text) {
  try {
    readText(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(WorldSamplerTest, WorldsAreValidAndWithinTheSettings) {
  const WorldSettings settings;
  sylph::Rng rng(1);
  int usual = 0;
  for (int world = 0; world < 100; ++world) {
    const sylph::Instance instance = sampleWorld(settings, rng);
    ASSERT_NO_THROW(sylph::requireValid(instance));
    EXPECT_GE(instance.grid.rows(), 10);
    EXPECT_LE(instance.grid.rows(), 40);
    EXPECT_LE(instance.agentCount(), settings.most_agents);
    EXPECT_LE(instance.agentCount(), 0.4 * instance.grid.freeCellCount() + 0.5);
    usual += instance.grid.rows() >= 20 && instance.grid.rows() <= 32 ? 1 : 0;
  }
  EXPECT_GT(usual, 50);
}

TEST(WorldSamplerTest, SameSeedSameWorld) {
  sylph::Rng first(7);
  sylph::Rng second(7);
  for (int world = 0; world < 5; ++world) {
    const sylph::Instance a = sampleWorld({}, first);
    const sylph::Instance b = sampleWorld({}, second);
    EXPECT_EQ(a.grid, b.grid);
    EXPECT_EQ(a.starts, b.starts);
    EXPECT_EQ(a.goals, b.goals);
  }
}

TEST(WorldSamplerTest, AFamilyWithoutWeightIsNeverDrawn) {
  WorldSettings settings = readText(
      "side: [12, 12]\nusual_share: 0\nroom: {weight: 0}\nmaze: {weight: 0}\n"
      "random: {density: [0, 0], team_share: [0.1, 0.1]}\n");
  sylph::Rng rng(3);
  for (int world = 0; world < 10; ++world) {
    const sylph::Instance instance = sampleWorld(settings, rng);
    EXPECT_EQ(144, instance.grid.freeCellCount());
    EXPECT_EQ(14, instance.agentCount());
  }
}

TEST(WorldSamplerTest, MalformedSettingsAreNamed) {
  EXPECT_NE(std::string::npos, errorOf("sides: [10, 40]\n").find("sides"));
  EXPECT_NE(std::string::npos, errorOf("side: [40, 10]\n").find("[lowest, highest]"));
  EXPECT_NE(std::string::npos, errorOf("side: [10.5, 40]\n").find("whole numbers"));
  EXPECT_NE(std::string::npos, errorOf("maze: {team_share: [0, 2]}\n").find("maze.team_share"));
  EXPECT_NE(std::string::npos,
            errorOf("random: {weight: 0}\nroom: {weight: 0}\nmaze: {weight: 0}\n").find("weight"));
}

}  // namespace
}  // namespace sylph_training
