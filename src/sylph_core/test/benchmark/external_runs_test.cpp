// External solvers in a suite: read, run by turns with planners, and judged like them.

#include <gtest/gtest.h>
#include <sched.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "sylph_core/benchmark/run_benchmark.hpp"
#include "sylph_core/benchmark/suite.hpp"
#include "sylph_core/text/join.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

const char kSuite[] = R"(planners: [pibt]
first: true
max_steps: 3
external:
  - {name: fake, command: "bin/fake {plan}"}
families:
  - {name: two, agents: [1, 2], map: a.map, scenarios: [a.scen]}
)";

class ExternalRunsTest : public ::testing::Test {
 protected:
  ExternalRunsTest() {
    folder_.write("a.map", "type octile\nheight 2\nwidth 3\nmap\n..@\n...\n");
    folder_.write("a.scen", "version 1\n0 a.map 3 2 0 0 1 0 1\n0 a.map 3 2 2 1 1 1 1\n");
    std::filesystem::create_directory(folder_.path("bin"));
  }

  /// The suite with another line for the solver.
  BenchmarkSuite suite(const std::string& solver = R"(name: fake, command: "bin/fake {plan}")") {
    std::string text = kSuite;
    const std::string from = R"(name: fake, command: "bin/fake {plan}")";
    text.replace(text.find(from), from.size(), solver);
    return loadSuite(folder_.write("suite.yaml", text));
  }

  /// A shell script that takes the plan's path as its first argument.
  void writeSolver(const std::string& script) const {
    const std::string path = folder_.write("bin/fake", "#!/bin/sh\n" + script);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }

  /// On the case of two agents, when its plan is this one.
  BenchmarkRun runWith(const std::string& plan) {
    folder_.write("given.txt", plan);
    writeSolver("cp given.txt \"$1\"\n");
    const BenchmarkSuite loaded = suite();
    const auto runs = runBenchmark(loaded, {makeCases(loaded).back()}, nullptr, 1,
                                   [](const BenchmarkRun&, std::size_t) {});
    EXPECT_EQ(2U, runs.size());
    return runs.back();
  }

  TemporaryFolder folder_;
};

TEST_F(ExternalRunsTest, TheSuiteNamesThem) {
  const std::vector<ExternalSolver> read =
      suite("name: l3, command: \"lacam3 -m {map} -o {plan}\", plan_format: lacam, grace_s: 2")
          .external;
  ASSERT_EQ(1U, read.size());
  EXPECT_EQ("l3", read[0].name);
  EXPECT_EQ((std::vector<std::string>{"lacam3", "-m", "{map}", "-o", "{plan}"}), read[0].command);
  EXPECT_EQ(PlanFormat::Lacam, read[0].plan_format);
  EXPECT_DOUBLE_EQ(2.0, read[0].grace_s);
  EXPECT_EQ(folder_.path(""), read[0].folder);
  expectError("/suite.yaml:5: external[0].command: there is no program 'lacam3' on the PATH",
              [&] { findProgram(read[0]); });
}

TEST_F(ExternalRunsTest, NamesTheFieldThatIsWrong) {
  const auto expect = [&](const std::string& error, const std::string& solver) {
    expectError("/suite.yaml:5: external[0]." + error, [&] { suite(solver); });
  };
  expect("name: is missing", "command: \"a {plan}\"");
  expect("name: 'lacam' is another planner's or solver's too", "name: lacam, command: a");
  expect("name: 'a,b' must have no comma, quote or line end", "name: \"a,b\", command: a");
  expect("command: has no {plan}, the file that the solver is to write", "name: a, command: a");
  expect(
      "command: '{x}' is no placeholder, must be one of {map}, {scen}, {agents}, {seconds}, "
      "{seed}, {plan}",
      "name: a, command: \"a {x}\"");
  expect("plan_format: is 'text', must be one of sylph, lacam, paths",
         "name: a, command: \"a {plan}\", plan_format: text");
  expect("grace_s: is '0', must be a number > 0", "name: a, command: \"a {plan}\", grace_s: 0");
  expect("shell: unknown key, must be one of name, command, plan_format, grace_s",
         "name: a, command: \"a {plan}\", shell: true");
}

TEST_F(ExternalRunsTest, PlansAreJudgedByOurChecker) {
  const BenchmarkRun solved = runWith("0: (0,0) (1,2)\n1: (0,1) (1,2)\n2: (0,1) (1,1)\n");
  EXPECT_EQ("solved", toString(solved.outcome)) << solved.message;
  EXPECT_TRUE(solved.evaluation.is_solved);
  EXPECT_EQ(3, solved.evaluation.metrics.sum_of_costs);
  EXPECT_EQ(2, solved.evaluation.sum_of_costs_lower_bound);
  EXPECT_NE(std::string::npos, toCsvLine(solved).find("fake,two,2,0,solved,2,2,3,2,2,,"))
      << toCsvLine(solved);

  const auto expectInvalid = [&](const std::string& message, const std::string& plan) {
    const BenchmarkRun run = runWith(plan);
    EXPECT_EQ("invalid", toString(run.outcome));
    EXPECT_FALSE(run.evaluation.is_solved);
    EXPECT_NE(std::string::npos, run.message.find(message)) << run.message;
    EXPECT_EQ(2, run.evaluation.sum_of_costs_lower_bound);
  };
  expectInvalid("step 1: agent 0 jumps from (0,0) to (1,1)",
                "0: (0,0) (1,2)\n1: (1,1) (1,2)\n2: (0,1) (1,1)\n");
  expectInvalid("step 1: agent 0 at (9999,2000000000), which is not a free cell",
                "0: (0,0) (1,2)\n1: (9999,2000000000) (1,1)\n");
  expectInvalid("step 0: 1 agents instead of 2", "0: (0,0)\n1: (0,1)\n");
  expectInvalid("/plan.txt:2: step 3: must be 1", "0: (0,0) (1,2)\n3: (0,1) (1,1)\n");
}

TEST_F(ExternalRunsTest, APlanOfMoreStepsThanAllowedIsNone) {
  const std::string waits = "0: (0,0) (1,2)\n1: (0,0) (1,2)\n2: (0,0) (1,2)\n";
  EXPECT_EQ("solved", toString(runWith(waits + "3: (0,1) (1,1)\n").outcome));
  EXPECT_EQ("step limit", toString(runWith(waits + "3: (0,0) (1,2)\n4: (0,1) (1,1)\n").outcome));
}

TEST_F(ExternalRunsTest, AllTakeTurnsAndRunsComeInOrder) {
  writeSolver("exit 1");
  std::vector<std::string> ended;
  const BenchmarkSuite loaded = suite();
  const auto runs = runBenchmark(loaded, makeCases(loaded), nullptr, 1,
                                 [&](const BenchmarkRun& run, std::size_t) {
                                   ended.push_back(run.planner + std::to_string(run.agents));
                                 });
  EXPECT_EQ("pibt1, fake1, pibt2, fake2", join(ended));
  EXPECT_EQ("pibt1, pibt2, fake1, fake2", join(runs, ", ", [](const BenchmarkRun& run) {
              return run.planner + std::to_string(run.agents);
            }));
  EXPECT_EQ(RunOutcome::Failed, runs.back().outcome);
}

TEST_F(ExternalRunsTest, ASolverKeepsToOneCpuAndTheCallerToThoseItHad) {
  writeSolver("grep Cpus_allowed_list /proc/self/status > cpus\n");
  cpu_set_t before{};
  ASSERT_EQ(0, sched_getaffinity(0, sizeof(before), &before));
  const BenchmarkSuite loaded = suite();
  runBenchmark(loaded, makeCases(loaded), nullptr, 1, [](const BenchmarkRun&, std::size_t) {});
  cpu_set_t after{};
  ASSERT_EQ(0, sched_getaffinity(0, sizeof(after), &after));
  EXPECT_TRUE(CPU_EQUAL(&before, &after));
  std::ifstream file(folder_.path("cpus"));
  const std::string cpus(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(std::string::npos, cpus.find_first_of(",-")) << cpus;
  EXPECT_NE(std::string::npos, cpus.find_first_of("0123456789")) << cpus;
}

}  // namespace
}  // namespace sylph
