#include "sylph_rehearsal/lab_fault.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

#include "sylph_rehearsal/seeds.hpp"

namespace sylph_rehearsal {
namespace {

class LabFaultTest : public testing::Test {
 protected:
  ~LabFaultTest() override { std::filesystem::remove(path_); }

  std::vector<LabFault> load(const std::string& text) const {
    std::ofstream(path_) << text;
    return loadFaults(path_, experiment_);
  }
  std::string refusal(const std::string& text) const {
    try {
      load(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    ADD_FAILURE() << "accepted: " << text;
    return {};
  }

  std::string path_ = testing::TempDir() + "sylph_lab_fault_test.yaml";
  sylph::Experiment experiment_ = experimentOf(std::string(MAPS_DIR) + "/lab_room.yaml", 1, 0);
};

TEST_F(LabFaultTest, AreReadFromASchedule) {
  const auto faults = load(
      "faults:\n"
      "  - {kind: swap, robots: [robot_1, robot_4], at_s: 2.0, duration_s: 0.5}\n"
      "  - {kind: network, at_s: 1, delay_s: 0.1, loss: 0.2}\n"
      "  - {kind: crash_central, at_s: 3}\n"
      "  - {kind: jump}\n");
  ASSERT_EQ(4U, faults.size());
  EXPECT_EQ(LabFaultKind::Simulated, faults[0].kind);
  EXPECT_EQ(sylph_sim::FaultKind::Swap, faults[0].fault.kind);
  EXPECT_EQ((std::vector<std::size_t>{1, 4}), faults[0].fault.robots);
  EXPECT_EQ(0.5, faults[0].fault.duration_s);
  EXPECT_EQ(LabFaultKind::Network, faults[1].kind);
  EXPECT_TRUE(faults[1].fault.robots.empty());
  EXPECT_EQ(0.1, faults[1].link.delay_s);
  EXPECT_EQ(0.2, faults[1].link.loss);
  EXPECT_EQ(LabFaultKind::CrashCentral, faults[2].kind);
  EXPECT_TRUE(std::isinf(faults[2].fault.duration_s));
  EXPECT_EQ(0.1, faults[3].fault.value) << "as the simulator has it";
}

TEST_F(LabFaultTest, NamesFileLineAndFieldOfWhatIsWrong) {
  EXPECT_EQ(0U, refusal("faults:\n  - {kind: danced}\n").find(path_ + ":2: faults[0].kind: "));
  EXPECT_NE(std::string::npos,
            refusal("faults:\n  - {kind: stuck, robots: [robot_9]}\n").find("'robot_9'"));
  EXPECT_NE(std::string::npos, refusal("faults:\n  - {kind: stuck, at_s: -1}\n").find("at_s"));
  EXPECT_NE(std::string::npos, refusal("faults:\n  - {kind: network, loss: 2}\n").find("loss"));
  EXPECT_NE(std::string::npos, refusal("faults:\n  - {kind: stuck, loss: 0}\n").find("loss"))
      << "only links lose messages";
  EXPECT_NE(std::string::npos,
            refusal("faults:\n  - {kind: swap, robots: [robot_1]}\n").find("two different robots"));
  EXPECT_NE(std::string::npos, refusal("faults:\n  - {at_s: 1}\n").find("kind"));
}

TEST_F(LabFaultTest, AreReadAsTheyAreWritten) {
  std::set<std::string> kinds;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    sylph::Rng rng(seed);
    std::string text = "faults:\n";
    const auto drawn = randomFaults(experiment_, rng);
    for (const LabFault& fault : drawn) {
      text += "  - " + toYaml(fault, experiment_) + "\n";
      kinds.insert(toName(fault));
    }
    const auto read = load(text);
    ASSERT_EQ(drawn.size(), read.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(toYaml(drawn[i], experiment_), toYaml(read[i], experiment_));
      EXPECT_EQ(drawn[i].fault.duration_s, read[i].fault.duration_s);
      EXPECT_EQ(drawn[i].fault.value, read[i].fault.value);
    }
  }
  EXPECT_EQ(23U, kinds.size()) << "every kind but launch_anew is drawn";
}

}  // namespace
}  // namespace sylph_rehearsal
