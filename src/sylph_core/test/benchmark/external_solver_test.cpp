#include "sylph_core/benchmark/external_solver.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/mapf/scenario_file.hpp"
#include "test/support/ended_process.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

const Instance kInstance = {
    Grid::fromText("..#\n...\n"), {{0, 0}, {1, 2}}, {{0, 1}, {1, 1}}, MotionModel()};
const char kWritesPlan[] = "printf '0: (0,0) (1,2)\\n1: (0,1) (1,1)\\n' > \"$1\"\n";

class ExternalSolverTest : public ::testing::Test {
 protected:
  /// A shell script that takes the plan's path as its first argument, and what follows {plan}.
  ExternalSolver solver(const std::string& script, const std::string& more = "") const {
    const std::string path = folder_.write("solver", "#!/bin/sh\n" + script);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    ExternalSolver made;
    made.name = "fake";
    made.command = splitCommand("./solver {plan} " + more);
    made.folder = folder_.path("");
    made.source = "suite.yaml:3: external[0].command: ";
    return made;
  }

  /// Of a solver that needs no time.
  static SolverAnswer answerOf(const ExternalSolver& solver) {
    return solve(solver, kInstance, 7, 60.0);
  }

  TemporaryFolder folder_;
};

TEST_F(ExternalSolverTest, ACommandIsSplitAtBlanks) {
  EXPECT_EQ((std::vector<std::string>{"bin/a", "--plan={plan}", "-t", "{seconds}"}),
            splitCommand("  bin/a --plan={plan}\t-t {seconds} "));
  const auto expectRefused = [](const std::string& error, const std::string& command) {
    try {
      splitCommand(command);
      ADD_FAILURE() << command;
    } catch (const std::invalid_argument& refused) {
      EXPECT_EQ(error, refused.what());
    }
  };
  const std::string allowed =
      " is no placeholder, must be one of {map}, {scen}, {agents}, {seconds}, {seed}, {plan}";
  expectRefused("'{maps}'" + allowed, "a {maps} {plan}");
  expectRefused("'{plan'" + allowed, "a {plan");
  expectRefused("has no {plan}, the file that the solver is to write", "a {map}");
  expectRefused("has no {plan}, the file that the solver is to write", "");
}

TEST_F(ExternalSolverTest, AProgramThatIsNotThereIsNamedWithItsField) {
  const std::string begin = "suite.yaml:3: external[0].command: there is no program ";
  ExternalSolver missing = solver("");
  missing.command = {"bin/none", "{plan}"};
  EXPECT_EQ(begin + folder_.path("bin/none") + " that can be executed",
            errorOf([&] { findProgram(missing); }));
  missing.command = {"no-such-solver", "{plan}"};
  EXPECT_EQ(begin + "'no-such-solver' on the PATH", errorOf([&] { findProgram(missing); }));
  folder_.write("text", "");
  missing.command = {"./text", "{plan}"};
  EXPECT_NE("", errorOf([&] { findProgram(missing); })) << "not executable";
  missing.command = {"sh", "{plan}"};
  EXPECT_EQ("", errorOf([&] { findProgram(missing); }));
}

TEST_F(ExternalSolverTest, PlaceholdersAreFilledInAndMayHoldBlanks) {
  std::filesystem::create_directory(folder_.path("with blanks"));
  const char* const folder_before = std::getenv("TMPDIR");
  setenv("TMPDIR", folder_.path("with blanks").c_str(), 1);
  const SolverAnswer answer =
      answerOf(solver("cp \"$2\" a.map; cp \"$3\" a.scen; echo \"$# $4\" > rest; exit 1",
                      "{map} {scen} {agents}/{seconds}/{seed}"));
  folder_before == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", folder_before, 1);
  EXPECT_EQ("4 2/60/7\n", contentOf(folder_.path("rest")));
  const Grid grid = loadMap(folder_.path("a.map"));
  EXPECT_EQ(kInstance.grid, grid);
  const Instance instance = loadScenario(folder_.path("a.scen"), grid, 2);
  EXPECT_EQ(kInstance.starts, instance.starts);
  EXPECT_EQ(kInstance.goals, instance.goals);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path("with blanks"))) << "its files are left";
}

TEST_F(ExternalSolverTest, APlanIsReadBackWhateverTheExitStatus) {
  for (const std::string end : {"", "exit 3"}) {
    const SolverAnswer answer = answerOf(solver(kWritesPlan + end));
    EXPECT_EQ(RunOutcome::Solved, answer.outcome) << answer.message;
    EXPECT_EQ(Plan({{{0, 0}, {1, 2}}, {{0, 1}, {1, 1}}}), answer.plan);
    EXPECT_EQ("", answer.message);
    EXPECT_GT(answer.seconds, 0.0);
  }
}

TEST_F(ExternalSolverTest, TellsWhyThereIsNoPlan) {
  const auto expect = [&](RunOutcome outcome, const std::string& message,
                          const std::string& script) {
    const SolverAnswer answer = answerOf(solver(script));
    EXPECT_EQ(toString(outcome), toString(answer.outcome)) << script;
    EXPECT_EQ(message, answer.message) << script;
    EXPECT_TRUE(answer.plan.empty());
  };
  expect(RunOutcome::NoSolution, "no plan, exit status 0; it printed nothing", "");
  expect(RunOutcome::NoSolution, "no plan, exit status 0; it printed nothing", ": > \"$1\"");
  expect(RunOutcome::Failed,
         "no plan, exit status 3; its last lines: two | thr?ee | four, on standard error",
         "printf 'one\\ntwo\\n\\nthr\\tee\\n'; echo four, on standard error >&2; exit 3");
  expect(RunOutcome::Failed, "killed by a signal: Segmentation fault; its last lines: begins",
         std::string("echo begins\n") + kWritesPlan + "kill -SEGV $$");
}

TEST_F(ExternalSolverTest, AFileThatIsNoProgramFails) {
  const ExternalSolver script = solver("");
  folder_.write("solver", "neither ELF nor a script");
  const SolverAnswer answer = answerOf(script);
  EXPECT_EQ(RunOutcome::Failed, answer.outcome);
  EXPECT_EQ("no plan, exit status 127; its last lines: the program cannot be executed",
            answer.message);
}

TEST_F(ExternalSolverTest, ADamagedPlanIsInvalid) {
  const SolverAnswer answer = answerOf(solver("echo '0: (0,0) (1' > \"$1\""));
  EXPECT_EQ(RunOutcome::Invalid, answer.outcome);
  EXPECT_NE(std::string::npos, answer.message.find("/plan.txt:1: '': must be ','"))
      << answer.message;
  ExternalSolver lacam = solver("echo solved=0 > \"$1\"");
  lacam.plan_format = PlanFormat::Lacam;
  EXPECT_EQ(RunOutcome::NoSolution, answerOf(lacam).outcome);
  EXPECT_EQ("", answerOf(lacam).message);
}

TEST_F(ExternalSolverTest, IsKilledWithAllThatItStartedWhenItDoesNotEnd) {
  ExternalSolver hangs = solver("sleep 1000 & echo $! > child\n" + std::string(kWritesPlan) +
                                "echo begun > begun; wait");
  hangs.grace_s = 0.5;
  const SolverAnswer answer = solve(hangs, kInstance, 7, 0.5);
  EXPECT_EQ(RunOutcome::TimeLimit, answer.outcome);
  EXPECT_GE(answer.seconds, 1.0);
  EXPECT_TRUE(endsSoon(folder_.path("child")));
}

TEST_F(ExternalSolverTest, WhatItLeavesRunningIsKilled) {
  const SolverAnswer answer =
      answerOf(solver("sleep 1000 & echo $! > child\n" + std::string(kWritesPlan)));
  EXPECT_EQ(RunOutcome::Solved, answer.outcome);
  EXPECT_TRUE(endsSoon(folder_.path("child")));
}

}  // namespace
}  // namespace sylph
