#include "sylph_training/imitation/symmetry.hpp"

#include <gtest/gtest.h>

#include "sylph_core/policy/observation.hpp"
#include "sylph_training/worlds/world_sampler.hpp"

namespace sylph_training {
namespace {

struct World {
  sylph::Instance instance;
  sylph::AgentStates states;
};

World drawWorld(sylph::Rng& rng) {
  WorldSettings settings;
  settings.side = settings.usual_side = {10, 14};
  World world{sampleWorld(settings, rng), {}};
  world.states.cells = world.instance.starts;
  for (std::size_t agent = 0; agent < world.instance.starts.size(); ++agent) {
    world.states.last_moves.push_back(
        static_cast<sylph::Action>(sylph::drawIndex(rng, sylph::kActionCount)));
    world.states.svo_deg.push_back(static_cast<float>(sylph::drawIndex(rng, 10)));
    world.states.priorities.push_back(static_cast<int>(sylph::drawIndex(rng, 100)));
    world.states.tie_breaks.push_back(static_cast<float>(sylph::drawFraction(rng)));
  }
  return world;
}

/// The whole world mirrored or turned, in its own terms.
World transformed(const World& world, int index) {
  const int side = world.instance.grid.rows();
  const auto image = [&](sylph::Cell cell) {
    if (index >= 4) {
      cell.col = side - 1 - cell.col;
    }
    for (int turn = 0; turn < index % 4; ++turn) {
      cell = {cell.col, side - 1 - cell.row};
    }
    return cell;
  };
  World result{{sylph::Grid(side, side), {}, {}, {}}, world.states};
  for (int cell = 0; cell < world.instance.grid.size(); ++cell) {
    const sylph::Cell at = world.instance.grid.cellAt(cell);
    result.instance.grid.setObstacle(image(at), !world.instance.grid.isFree(at));
  }
  for (std::size_t agent = 0; agent < world.instance.starts.size(); ++agent) {
    result.states.cells[agent] = image(world.states.cells[agent]);
    result.instance.goals.push_back(image(world.instance.goals[agent]));
    const sylph::Cell moved =
        sylph::neighbor(world.states.cells[agent], world.states.last_moves[agent]);
    result.states.last_moves[agent] =
        sylph::actionBetween(image(world.states.cells[agent]), image(moved)).value();
  }
  return result;
}

struct Seen {
  std::vector<PackedView> views;
  std::vector<std::array<float, sylph::kVectorSize>> vectors;
};

Seen observe(const World& world) {
  std::vector<sylph::DistanceField> distances;
  for (const sylph::Cell& goal : world.instance.goals) {
    distances.emplace_back(world.instance.grid, goal);
  }
  sylph::ObservationEncoder encoder(world.instance.grid, distances);
  encoder.setStates(world.states);
  Seen seen;
  std::vector<float> view(sylph::kObservationSize);
  for (std::size_t agent = 0; agent < distances.size(); ++agent) {
    seen.vectors.emplace_back();
    encoder.encode(static_cast<sylph::AgentId>(agent), view.data(), seen.vectors.back().data());
    seen.views.push_back(packView(view.data()));
  }
  return seen;
}

TEST(SymmetryTest, WhatIsSeenOfTheImageIsTheImageOfWhatIsSeen) {
  sylph::Rng rng(11);
  for (int trial = 0; trial < 4; ++trial) {
    const World world = drawWorld(rng);
    const Seen seen = observe(world);
    for (int index = 0; index < Symmetry::kCount; ++index) {
      SCOPED_TRACE(index);
      const Symmetry symmetry(index);
      const Seen image = observe(transformed(world, index));
      for (std::size_t agent = 0; agent < seen.views.size(); ++agent) {
        ASSERT_EQ(image.views[agent], symmetry.apply(seen.views[agent]));
        ASSERT_EQ(image.vectors[agent], symmetry.apply(seen.vectors[agent]));
      }
    }
  }
}

TEST(SymmetryTest, ThereAndBackIsTheIdentity) {
  sylph::Rng rng(12);
  const Seen seen = observe(drawWorld(rng));
  for (int index = 0; index < Symmetry::kCount; ++index) {
    SCOPED_TRACE(index);
    const Symmetry there(index);
    const Symmetry back = there.inverse();
    EXPECT_EQ(seen.views.front(), back.apply(there.apply(seen.views.front())));
    EXPECT_EQ(seen.vectors.front(), back.apply(there.apply(seen.vectors.front())));
    for (const sylph::Action action : sylph::kActions) {
      EXPECT_EQ(action, back.apply(there.apply(action)));
    }
  }
  EXPECT_THROW(Symmetry(8), std::invalid_argument);
  EXPECT_THROW(Symmetry(-1), std::invalid_argument);
}

TEST(SymmetryTest, ActionsTurnClockwiseAndMirrorEastAndWest) {
  EXPECT_EQ(sylph::Action::East, Symmetry(1).apply(sylph::Action::North));
  EXPECT_EQ(sylph::Action::North, Symmetry(1).apply(sylph::Action::West));
  EXPECT_EQ(sylph::Action::West, Symmetry(4).apply(sylph::Action::East));
  EXPECT_EQ(sylph::Action::Stay, Symmetry(6).apply(sylph::Action::Stay));
}

}  // namespace
}  // namespace sylph_training
