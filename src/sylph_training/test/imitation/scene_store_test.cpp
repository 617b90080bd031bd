#include "sylph_training/imitation/scene_store.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

#include "sylph_training/imitation/demonstration.hpp"
#include "sylph_training/imitation/symmetry.hpp"
#include "sylph_training/worlds/world_sampler.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph_training {
namespace {

SceneStore smallStore(std::uint32_t seed) {
  WorldSettings worlds;
  worlds.side = worlds.usual_side = {10, 12};
  DemonstrationSettings settings;
  settings.improvement_s = 0.01;
  settings.samples_per_world = 100;
  sylph::Rng rng(seed);
  SceneStore store;
  for (int world = 0; world < 3; ++world) {
    const sylph::Instance instance = sampleWorld(worlds, rng);
    const sylph::SearchProblem problem(instance);
    const auto plan = findExpertPlan(problem, settings, rng);
    if (plan) {
      addScenes(instance, problem,
                {*plan, std::vector<sylph::Action>(instance.starts.size()),
                 static_cast<int>(plan->size())},
                settings.samples_per_world, settings, rng, store);
    }
  }
  return store;
}

void expectEqual(const SceneStore& a, const SceneStore& b, std::size_t first_of_b) {
  for (std::size_t scene = 0; scene < a.sceneCount(); ++scene) {
    const auto agents = a.agents(scene);
    const auto samples = a.samples(scene);
    const auto other_agents = b.agents(first_of_b + scene);
    const auto other_samples = b.samples(first_of_b + scene);
    ASSERT_EQ(agents.count, other_agents.count);
    ASSERT_EQ(samples.count, other_samples.count);
    for (std::size_t agent = 0; agent < agents.count; ++agent) {
      EXPECT_EQ(agents[agent].vector, other_agents[agent].vector);
      EXPECT_EQ(agents[agent].partner, other_agents[agent].partner);
      EXPECT_EQ(agents[agent].svo_centideg, other_agents[agent].svo_centideg);
    }
    for (std::size_t sample = 0; sample < samples.count; ++sample) {
      EXPECT_EQ(samples[sample].agent, other_samples[sample].agent);
      EXPECT_EQ(samples[sample].action, other_samples[sample].action);
      EXPECT_EQ(samples[sample].votes, other_samples[sample].votes);
      EXPECT_EQ(samples[sample].only_ties, other_samples[sample].only_ties);
      EXPECT_EQ(samples[sample].regrets, other_samples[sample].regrets);
      EXPECT_EQ(samples[sample].view, other_samples[sample].view);
    }
  }
}

TEST(SceneStoreTest, FilesThereAndBackAreTheSame) {
  const sylph::TemporaryFolder folder;
  const SceneStore first = smallStore(1);
  const SceneStore second = smallStore(2);
  ASSERT_GT(first.sampleCount(), 50U);
  first.save(folder.path("first"));
  second.save(folder.path("second"));
  SceneStore both;
  both.load(folder.path("first"));
  both.load(folder.path("second"));
  ASSERT_EQ(first.sceneCount() + second.sceneCount(), both.sceneCount());
  expectEqual(first, both, 0);
  expectEqual(second, both, first.sceneCount());
}

TEST(ProcessorTimeTest, StandsStillWhileOthersHaveTheProcessor) {
  constexpr std::chrono::milliseconds kAside(100);
  const double before_s = processorTime();
  std::this_thread::sleep_for(kAside);
  EXPECT_GE(processorTime(), before_s);
  EXPECT_LT(processorTime() - before_s, std::chrono::duration<double>(kAside).count());
}

TEST(SceneStoreTest, DamagedFilesAreRefused) {
  const sylph::TemporaryFolder folder;
  smallStore(1).save(folder.path("scenes"));
  std::filesystem::resize_file(folder.path("scenes"),
                               std::filesystem::file_size(folder.path("scenes")) - 1);
  SceneStore store;
  EXPECT_THROW(store.load(folder.path("scenes")), std::runtime_error);
  EXPECT_THROW(store.load(folder.write("text", "scenes")), std::runtime_error);
  EXPECT_THROW(store.load(folder.path("none")), std::runtime_error);
  EXPECT_EQ(0U, store.sceneCount());
}

TEST(SceneStoreTest, AFileThatIsNotThereIsNoFileOfAnotherVersion) {
  const sylph::TemporaryFolder folder;
  try {
    SceneStore().load(folder.path("scenes"));
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(folder.path("scenes") + ": cannot be opened: No such file or directory",
              std::string(error.what()));
  }
}

TEST(SceneStoreTest, AFullDiskIsNamed) {
  const sylph::TemporaryFolder folder;
  const std::string path = folder.path("scenes");
  std::filesystem::create_symlink("/dev/full", path + ".partial");
  sylph::expectError("scenes.partial: cannot be written: No space left on device",
                     [&] { SceneStore().save(path); });
}

TEST(SceneStoreTest, RowsOutOfRangeAreRefused) {
  const sylph::TemporaryFolder folder;
  Scene sound;
  sound.agents.resize(2);
  sound.samples.resize(1);
  const auto expectRefused = [&](const Scene& scene) {
    SceneStore store;
    store.add(scene);
    store.save(folder.path("scenes"));
    SceneStore loaded;
    EXPECT_THROW(loaded.load(folder.path("scenes")), std::runtime_error);
    EXPECT_EQ(0U, loaded.sceneCount());
  };
  SceneStore store;
  store.add(sound);
  store.save(folder.path("sound"));
  EXPECT_NO_THROW(SceneStore().load(folder.path("sound")));
  Scene broken = sound;
  broken.agents[1].partner = 2;
  expectRefused(broken);
  broken = sound;
  broken.agents[0].svo_centideg = 4501;
  expectRefused(broken);
  broken = sound;
  broken.samples[0].agent = 2;
  expectRefused(broken);
  broken = sound;
  broken.samples[0].action = 5;
  expectRefused(broken);
  broken = sound;
  broken.samples[0].only_ties = 2;
  expectRefused(broken);
}

TEST(SceneStoreTest, ViewsArePackedWithoutLossButForGaps) {
  sylph::Rng rng(5);
  sylph::Instance instance = sampleWorld({}, rng);
  std::vector<sylph::DistanceField> distances;
  for (const sylph::Cell& goal : instance.goals) {
    distances.emplace_back(instance.grid, goal);
  }
  sylph::ObservationEncoder encoder(instance.grid, distances);
  sylph::AgentStates states;
  states.cells = instance.starts;
  for (std::size_t agent = 0; agent < instance.starts.size(); ++agent) {
    states.last_moves.push_back(static_cast<sylph::Action>(sylph::drawIndex(rng, 5)));
    states.svo_deg.push_back(45.F * static_cast<float>(sylph::drawFraction(rng)));
    states.priorities.push_back(static_cast<int>(sylph::drawIndex(rng, 100)));
    states.tie_breaks.push_back(static_cast<float>(sylph::drawFraction(rng)));
  }
  encoder.setStates(states);
  std::vector<float> view(sylph::kObservationSize);
  std::vector<float> unpacked(sylph::kObservationSize);
  std::array<float, sylph::kVectorSize> vector{};
  for (sylph::AgentId agent = 0; agent < instance.agentCount(); ++agent) {
    encoder.encode(agent, view.data(), vector.data());
    unpackView(packView(view.data()), unpacked.data());
    for (std::size_t index = 0; index < view.size(); ++index) {
      const auto channel = static_cast<sylph::Channel>(index % sylph::kChannelCount);
      const bool is_gap =
          channel == sylph::Channel::SvoGap || channel == sylph::Channel::InheritedGap;
      ASSERT_NEAR(view[index], unpacked[index], is_gap ? 0.5 / 127.0 + 1e-6 : 0.0) << index;
    }
  }
}

}  // namespace
}  // namespace sylph_training
