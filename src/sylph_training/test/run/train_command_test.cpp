#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "sylph_core/policy/policy.hpp"
#include "sylph_core/policy/tensor_file.hpp"
#include "test/support/temporary_folder.hpp"

namespace {

constexpr char kConfig[] = R"(
seed: 5
checkpoint_interval_s: 0.001
shards: 2
validation_shards: 1
worlds_per_shard: 2
network: {near_width: 4, far_width: 4, goal_width: 4, message_width: 4, width: 16, semantic_tokens: 4}
worlds: {side: [10, 11], usual_side: [10, 11], most_agents: 20}
demonstrations: {improvement_s: 0.01, samples_per_world: 100}
phases:
  - {kind: imitation, steps: 60, batch: 64, first_shards: 2, log_steps: 2, validation_steps: 20,
     validation_samples: 50, learning_rate: 0.01, precision: float}
)";

pid_t start(const std::vector<std::string>& arguments, const std::string& output) {
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen(output.c_str(), "w", stdout) == nullptr ||
        std::freopen(output.c_str(), "a", stderr) == nullptr) {
      _exit(126);
    }
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (const std::string& argument : arguments) {
      argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

int wait(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

std::string read(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

class TrainCommandTest : public ::testing::Test {
 protected:
  std::vector<std::string> train(const std::string& run, bool resume = false) const {
    std::vector<std::string> command = {TRAIN_COMMAND, folder_.path("config.yaml"), "--run",
                                        folder_.path(run)};
    if (resume) {
      command.emplace_back("--resume");
    }
    return command;
  }
  void expectKilledRunGoesOn(const std::string& config);
  std::string output() const { return folder_.path("output"); }

  sylph::TemporaryFolder folder_;
};

// Shards led by the policy and meters on the way.
constexpr char kReactive[] = R"(
     , reactive: {teacher_shards: 1, student_steps: 20, worlds_per_shard: 2, samples_per_world: 100},
     meter_steps: 50, meters: {worlds: 1, steps: 2}}
)";

void TrainCommandTest::expectKilledRunGoesOn(const std::string& config) {
  folder_.write("config.yaml", config);
  ASSERT_EQ(0, wait(start(train("whole"), output()))) << read(output());
  std::filesystem::create_directory(folder_.path("killed"));
  for (const std::string data :
       {"/demonstrations", "/validation", "/teacher_led", "/validation_teacher_led"}) {
    if (std::filesystem::exists(folder_.path("whole") + data)) {
      std::filesystem::copy(folder_.path("whole") + data, folder_.path("killed") + data);
    }
  }
  const pid_t child = start(train("killed"), output());
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!std::filesystem::exists(folder_.path("killed/weights.safetensors")) &&
         std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(child, SIGKILL);
  EXPECT_TRUE(WIFSIGNALED(wait(child))) << "done before it was killed: " << read(output());
  ASSERT_EQ(0, wait(start(train("killed", true), output()))) << read(output());
  EXPECT_EQ(read(folder_.path("whole/weights.safetensors")),
            read(folder_.path("killed/weights.safetensors")));
  EXPECT_EQ(read(folder_.path("whole/log_0_imitation.csv")),
            read(folder_.path("killed/log_0_imitation.csv")));
  const auto policy = sylph::Policy::load(folder_.path("killed/weights.safetensors"));
  EXPECT_EQ(16, policy.network().shape().width);
}

TEST_F(TrainCommandTest, AKilledRunGoesOnAsIfNothingHadHappened) {
  expectKilledRunGoesOn(kConfig);
}

TEST_F(TrainCommandTest, SoDoesOneThatTheReactiveTeacherLabels) {
  std::string config = kConfig;
  expectKilledRunGoesOn(config.replace(config.rfind('}'), 1, kReactive));
}

TEST_F(TrainCommandTest, BadInputIsOneLineAndStatus2) {
  folder_.write("config.yaml", kConfig);
  const int status = wait(start(train("none", true), output()));
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(2, WEXITSTATUS(status));
  const std::string text = read(output());
  EXPECT_EQ(1, std::count(text.begin(), text.end(), '\n')) << text;
  EXPECT_NE(std::string::npos, text.find("nothing can be resumed")) << text;
}

}  // namespace
