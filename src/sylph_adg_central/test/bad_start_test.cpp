#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

struct Ending {
  int status = 0;
  std::string output;
};

/// Runs a node of this package to its end, which has to come at once.
/// @param experiment  file beside this test, empty: none
Ending runNode(const std::string& node, const std::string& experiment,
               const std::string& arguments) {
  if (!experiment.empty()) {
    ros::param::set("/bad_start/experiment",
                    ros::package::getPath("sylph_adg_central") + "/test/" + experiment);
  }
  ros::param::set("/bad_start/run_folder", testing::TempDir() + "sylph_bad_start");
  // The nodes are built into the folder of this test.
  const std::string folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string command =
      "timeout 20 " + folder + "/" + node + " __ns:=bad_start " + arguments + " 2>&1";
  Ending ending;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 512> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    ending.output += buffer.data();
  }
  ending.status = WEXITSTATUS(pclose(pipe));
  ros::param::del("/bad_start");
  return ending;
}

void expectRefusal(const std::string& node, const std::string& experiment,
                   const std::string& arguments, const std::string& expected) {
  SCOPED_TRACE(node + " " + experiment + " " + arguments);
  const Ending ending = runNode(node, experiment, arguments);
  EXPECT_EQ(1, ending.status);
  EXPECT_NE(std::string::npos, ending.output.find(expected)) << ending.output;
}

TEST(BadStartTest, CentralNodeNamesWhatIsWrong) {
  const std::string node = "sylph_adg_central";
  const std::string lab = "lab.yaml";
  const std::string no_margin = "no_margin.yaml";
  expectRefusal(node, "", "", "parameter /bad_start/experiment: must be set");
  expectRefusal(node, no_margin, "", "no safety margin: robots stay 5.8 mm apart");
  expectRefusal(node, no_margin, "", "change cell_size_m = 0.27 to at least 0.2897");
  expectRefusal(node, lab, "_lookahead:=0", "must be 1");
  expectRefusal(node, lab, "_silent_after_s:=0.0", "must be > 0");
  expectRefusal(node, lab, "_lost_after_s:=-1.0", "must be >= 0");
  expectRefusal(node, lab, "_lookahed:=3", "lookahed: unknown");
}

TEST(BadStartTest, SeparationMonitorNamesWhatIsWrong) {
  const std::string node = "sylph_separation_monitor";
  expectRefusal(node, "no_margin.yaml", "", "no safety margin");
  expectRefusal(node, "lab.yaml", "_limit_m:=0.02", "limit_m = 0.02: must be at most the");
  expectRefusal(node, "lab.yaml", "_confirmations:=0", "must be 1");
  expectRefusal(node, "lab.yaml", "_limit:=0.01", "limit: unknown");
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "bad_start_test");
  const ros::NodeHandle keep_ros_running;
  return RUN_ALL_TESTS();
}
