#include "sylph_core/policy/observation.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace sylph {
namespace {

class ObservationTest : public ::testing::Test {
 protected:
  // 0 goes from the middle to the east, 1 stands on its goal west of it, 2 comes from the north.
  ObservationTest() {
    for (const Cell& goal : {Cell{2, 5}, Cell{2, 1}, Cell{4, 4}}) {
      distances_.emplace_back(grid_, goal);
    }
    states_.cells = {{2, 2}, {2, 1}, {1, 4}};
    states_.last_moves = {Action::East, Action::Stay, Action::South};
    states_.svo_deg = {20.F, 45.F, 5.F};
    states_.priorities = {16, 0, 400};
    states_.tie_breaks = {0.25F, 0.5F, 0.75F};
  }

  void encode(AgentId agent) {
    ObservationEncoder encoder(grid_, distances_);
    encoder.setStates(states_);
    encoder.encode(agent, view_.data(), vector_.data());
  }

  float at(AgentId agent, const Cell& cell, Channel channel) const {
    const Cell& center = states_.cells[static_cast<std::size_t>(agent)];
    const int row = cell.row - center.row + kFieldOfView / 2;
    const int col = cell.col - center.col + kFieldOfView / 2;
    return view_[static_cast<std::size_t>((row * kFieldOfView + col) * kChannelCount +
                                          static_cast<int>(channel))];
  }

  Grid grid_ = Grid::fromText(
      "......\n"
      "......\n"
      "...#..\n"
      "......\n"
      "......\n");
  std::vector<DistanceField> distances_;
  AgentStates states_;
  std::vector<float> view_ = std::vector<float>(kObservationSize);
  std::vector<float> vector_ = std::vector<float>(kVectorSize);
};

TEST_F(ObservationTest, SeesObstaclesAndTheEdgeOfTheMap) {
  encode(0);
  EXPECT_EQ(1.F, at(0, {2, 3}, Channel::Obstacle));
  EXPECT_EQ(1.F, at(0, {-1, 2}, Channel::Obstacle));
  EXPECT_EQ(1.F, at(0, {2, 6}, Channel::Obstacle));
  EXPECT_EQ(0.F, at(0, {4, 4}, Channel::Obstacle));
  EXPECT_EQ(1.F, at(0, {2, 3}, Channel::CostToGo));
}

TEST_F(ObservationTest, SeesTheWayRoundAnObstacle) {
  encode(0);
  EXPECT_EQ(1.F, at(0, {2, 2}, Channel::NearerNorth));
  EXPECT_EQ(1.F, at(0, {2, 2}, Channel::NearerSouth));
  EXPECT_EQ(0.F, at(0, {2, 2}, Channel::NearerEast));
  EXPECT_EQ(1.F, at(0, {1, 4}, Channel::NearerEast));
  EXPECT_EQ(0.F, at(0, {2, 2}, Channel::CostToGo));
  EXPECT_FLOAT_EQ(1.F / 8.F, at(0, {2, 1}, Channel::CostToGo));
}

TEST_F(ObservationTest, SeesTheOthersAndWhatTheyWant) {
  encode(0);
  EXPECT_EQ(1.F, at(0, {2, 2}, Channel::Agent));
  EXPECT_EQ(1.F, at(0, {2, 2}, Channel::CameEast)) << "one's own last move";
  EXPECT_EQ(0.F, at(0, {2, 2}, Channel::DesiredNorth)) << "that stands in one's own way";
  EXPECT_FLOAT_EQ(25.F / 45.F, at(0, {2, 1}, Channel::SvoGap));
  EXPECT_FLOAT_EQ(-15.F / 45.F, at(0, {1, 4}, Channel::SvoGap));
  EXPECT_EQ(1.F, at(0, {2, 1}, Channel::AtGoal));
  EXPECT_EQ(0.F, at(0, {2, 1}, Channel::LessProsocial));
  EXPECT_EQ(1.F, at(0, {1, 4}, Channel::Agent));
  EXPECT_EQ(1.F, at(0, {1, 4}, Channel::LessProsocial));
  EXPECT_EQ(1.F, at(0, {1, 4}, Channel::CameSouth));
  EXPECT_EQ(1.F, at(0, {1, 4}, Channel::DesiredSouth));
  EXPECT_EQ(0.F, at(0, {1, 4}, Channel::DesiredNorth));
  EXPECT_EQ(0.F, at(0, {1, 4}, Channel::FartherToGo));
  EXPECT_EQ(1.F, at(0, {2, 5}, Channel::OwnGoal));
  EXPECT_EQ(1.F, at(0, {4, 4}, Channel::OtherGoal));
  EXPECT_EQ(1.F, at(0, {4, 4}, Channel::ProjectedGoal));
}

TEST_F(ObservationTest, ClampsGoalsToTheBorderOfTheView) {
  grid_ = Grid(3, 20);
  distances_.clear();
  distances_.emplace_back(grid_, Cell{0, 0});
  distances_.emplace_back(grid_, Cell{1, 19});
  states_ = {{{1, 5}, {1, 6}}, {Action::Stay, Action::Stay}, {0.F, 0.F}, {1, 1}, {0.F, 0.F}};
  encode(0);
  EXPECT_EQ(1.F, at(0, {1, 9}, Channel::ProjectedGoal));
  EXPECT_EQ(0.F, at(0, {1, 9}, Channel::OtherGoal));
}

TEST_F(ObservationTest, VectorPointsToTheGoal) {
  encode(2);
  EXPECT_FLOAT_EQ(0.F, vector_[0]);
  EXPECT_FLOAT_EQ(-1.F, vector_[1]);
  EXPECT_FLOAT_EQ(3.F / 64.F, vector_[2]);
  EXPECT_FLOAT_EQ(3.F / 64.F, vector_[3]);
  EXPECT_EQ(0.F, vector_[4]);
  EXPECT_EQ(2.5F, vector_[5]) << "saturated";
  EXPECT_EQ(0.75F, vector_[6]);
  encode(0);
  EXPECT_EQ(0.25F, vector_[5]);
  encode(1);
  EXPECT_EQ(std::vector<float>({0.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.5F}), vector_);
}

TEST_F(ObservationTest, ForgetsWhereAgentsWere) {
  ObservationEncoder encoder(grid_, distances_);
  encoder.setStates(states_);
  states_.cells[2] = {0, 0};
  encoder.setStates(states_);
  encoder.encode(0, view_.data(), vector_.data());
  EXPECT_EQ(0.F, at(0, {1, 4}, Channel::Agent));
  EXPECT_EQ(1.F, at(0, {0, 0}, Channel::Agent));
}

TEST_F(ObservationTest, RefusesStatesOfAnotherNumberOfAgents) {
  ObservationEncoder encoder(grid_, distances_);
  states_.cells.pop_back();
  EXPECT_THROW(encoder.setStates(states_), std::invalid_argument);
}

TEST_F(ObservationTest, SeesWhoHasToMakeWay) {
  grid_ = Grid::fromText(
      "###.###\n"
      ".......\n"
      "#######\n");
  distances_.clear();
  distances_.emplace_back(grid_, Cell{1, 6});
  distances_.emplace_back(grid_, Cell{1, 0});
  states_ = {{{1, 1}, {1, 2}}, {Action::East, Action::West}, {5.F, 40.F}, {1, 1}, {0.F, 0.F}};
  encode(1);
  EXPECT_EQ(1.F, at(1, {1, 2}, Channel::SwapWest)) << "with a junction behind it";
  EXPECT_EQ(1.F, at(1, {1, 2}, Channel::Pressed)) << "and goes first";
  EXPECT_FLOAT_EQ(-35.F / 45.F, at(1, {1, 2}, Channel::InheritedGap));
  EXPECT_EQ(0.F, at(1, {1, 1}, Channel::InheritedGap)) << "both act for the other";
  EXPECT_EQ(0.F, at(1, {1, 1}, Channel::Pressed));
}

TEST(ObservationEntriesTest, AreAsManyAsThereAreInputsAndAllDifferent) {
  std::set<std::string> names;
  for (const ObservationEntry& entry : observationEntries()) {
    names.insert(entry.name);
    EXPECT_LT(entry.lowest, entry.highest);
  }
  EXPECT_EQ(static_cast<std::size_t>(kChannelCount + kVectorSize), names.size());
  EXPECT_EQ("inherited_gap", observationEntries()[kChannelCount - 1].name);
  EXPECT_EQ("tie_break", observationEntries().back().name);
}

TEST(ObservationEntriesTest, AreWhatTheDocumentationSays) {
  std::ifstream file(std::string(REPOSITORY_DIR) + "/docs/observation.md");
  std::vector<std::string> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("| `", 0) == 0) {
      rows.push_back(line);
    }
  }
  std::vector<std::string> expected;
  for (const ObservationEntry& entry : observationEntries()) {
    std::ostringstream row;
    row << "| `" << entry.name << "` | " << entry.meaning << " | " << entry.lowest << " ... "
        << entry.highest << " |";
    expected.push_back(row.str());
  }
  EXPECT_EQ(expected, rows);
}

}  // namespace
}  // namespace sylph
