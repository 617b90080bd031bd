#include "sylph_rviz/experiment_choices.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "sylph_core/files/scratch_folder.hpp"

namespace sylph_rviz {
namespace {

constexpr char kMap[] = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";
constexpr char kWideMap[] = "type octile\nheight 2\nwidth 4\nmap\n....\n....\n";

/// A folder of experiments.
class ExperimentChoicesTest : public ::testing::Test {
 protected:
  ExperimentChoicesTest() {
    folder_.write("lab.map", kMap);
    folder_.write("wide.map", kWideMap);
    experiment("lab", "lab.map", 0.3, {"alpha", "beta"});
  }

  void experiment(const std::string& name, const std::string& map, double cell_size_m,
                  const std::vector<std::string>& robots) const {
    std::string text = "map: " + map + "\ncell_size_m: " + std::to_string(cell_size_m) +
                       "\nstarts: random\ngoals: random\nrobots:\n";
    for (const std::string& robot : robots) {
      text += "  - {name: " + robot + "}\n";
    }
    folder_.write(name + ".yaml", text);
  }
  std::string lab() const { return folder_.path("lab.yaml"); }

  sylph::ScratchFolder folder_{"choices"};
};

TEST_F(ExperimentChoicesTest, AreTheLabsOwnFirstAndThenTheOthersByName) {
  experiment("b", "lab.map", 0.3, {"beta"});
  experiment("a", "lab.map", 0.3, {"alpha"});
  folder_.write("map.yaml", "image: lab.png\n");
  const auto choices = experimentChoices(lab());
  ASSERT_EQ(3U, choices.size()) << "a map's file is no experiment";
  EXPECT_EQ("lab", choices[0].name);
  EXPECT_EQ("a", choices[1].name);
  EXPECT_EQ("b", choices[2].name);
  EXPECT_EQ("", choices[2].refusal);
}

TEST_F(ExperimentChoicesTest, SayWhyOneDoesNotFitTheLab) {
  experiment("a", "wide.map", 0.3, {"alpha"});
  experiment("b", "lab.map", 0.5, {"alpha"});
  experiment("c", "lab.map", 0.3, {"gamma"});
  const auto choices = experimentChoices(lab());
  ASSERT_EQ(4U, choices.size());
  EXPECT_EQ("its map has 2 x 4 cells, the lab's 2 x 3", choices[1].refusal);
  EXPECT_EQ("its cells do not lie where the lab's do", choices[2].refusal);
  EXPECT_EQ("the lab has no robot gamma", choices[3].refusal);
}

TEST_F(ExperimentChoicesTest, ThrowsIfTheLabsOwnIsNone) {
  EXPECT_THROW(experimentChoices(folder_.path("nothing.yaml")), std::runtime_error);
}

}  // namespace
}  // namespace sylph_rviz
