// External solvers in a suite: read, run by turns with planners, and judged like them.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sylph_core/benchmark/suite.hpp"
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
  }

  /// The suite with another line for the solver.
  BenchmarkSuite suite(const std::string& solver = R"(name: fake, command: "bin/fake {plan}")") {
    std::string text = kSuite;
    const std::string from = R"(name: fake, command: "bin/fake {plan}")";
    text.replace(text.find(from), from.size(), solver);
    return loadSuite(folder_.write("suite.yaml", text));
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

}  // namespace
}  // namespace sylph
