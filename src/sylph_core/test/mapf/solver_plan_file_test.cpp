#include "sylph_core/mapf/solver_plan_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

// Two agents on a map of two rows and three columns.
const Plan kPlan = {{{0, 0}, {1, 2}}, {{0, 1}, {1, 2}}, {{0, 2}, {1, 1}}};

const char kLacam[] =
    "agents=2\nmap_file=a.map\nsolver=planner\nsolved=1\nsoc=4\nsoc_lb=3\nmakespan=2\n"
    "makespan_lb=2\nsum_of_loss=3\nsum_of_loss_lb=3\ncomp_time=0.125\nseed=0\n"
    "checkpoints=4,\nstarts=(0,0),(2,1),\ngoals=(2,0),(1,1),\nsolution=\n"
    "0:(0,0),(2,1),\n1:(1,0),(2,1),\n2:(2,0),(1,1),\n";

class SolverPlanFileTest : public ::testing::Test {
 protected:
  std::optional<Plan> load(const std::string& content, PlanFormat format) const {
    return loadSolverPlan(folder_.write("plan.txt", content), format);
  }

  void expectRefused(const std::string& error, const std::string& content,
                     PlanFormat format) const {
    expectError("/plan.txt" + error, [&] { load(content, format); });
  }

  TemporaryFolder folder_;
};

TEST_F(SolverPlanFileTest, ReadsOurOwnFormat) {
  EXPECT_EQ(kPlan,
            load("0: (0,0) (1,2)\n1: (0,1) (1,2)\n2: (0,2) (1,1)\n", PlanFormat::Sylph).value());
  expectRefused(": is empty, must start with '0: (row,col) (row,col) ...'", "", PlanFormat::Sylph);
}

TEST_F(SolverPlanFileTest, LacamWritesTheColumnFirst) {
  EXPECT_EQ(kPlan, load(kLacam, PlanFormat::Lacam).value());
  EXPECT_EQ(Plan({{{1, 0}}}), load("solution=\r\n0:(0,1)\r\n", PlanFormat::Lacam).value());
}

TEST_F(SolverPlanFileTest, LacamSaysThatThereIsNoSolution) {
  EXPECT_FALSE(load("agents=2\nsolved=0\nsoc=0\nsolution=\n", PlanFormat::Lacam).has_value());
  EXPECT_FALSE(load("agents=2\nsolved=0\nsoc=0\n", PlanFormat::Lacam).has_value());
}

TEST_F(SolverPlanFileTest, NamesTheLineThatIsWrongInLacamsFormat) {
  const auto expect = [&](const std::string& error, const std::string& content) {
    expectRefused(error, content, PlanFormat::Lacam);
  };
  const std::string form = " here, a line is 'step:(x,y),(x,y),'";
  expect(": has no line 'solution=' and no line 'solved=0'", "");
  expect(": has no line 'solution=' and no line 'solved=0'", "solved=1\nsoc=4\n");
  expect(":2: has no step below 'solution='", "solved=1\nsolution=\n");
  expect(":2: step 1: must be 0", "solution=\n1:(0,0),\n");
  expect(":3: '0,0),': must be '('" + form, "solution=\n0:(0,0),\n1:0,0),\n");
  expect(":2: '(1,1)': must be ','" + form, "solution=\n0:(0,0)(1,1)\n");
  expect(":2: '': must be ')'" + form, "solution=\n0:(0,0),(1,1");
  expect(":2: '99999999999),': must be a whole number" + form, "solution=\n0:(0,99999999999),\n");
  expect(":2: 0 agents: must be 1 or more", "solution=\n0:\n");
  expect(":3: 1 agents: must be 2, as in step 0", "solution=\n0:(0,0),(1,1),\n1:(0,0),\n");
}

TEST_F(SolverPlanFileTest, PathsOfAgentsRestAtTheirEnd) {
  const Plan plan = {{{0, 0}, {1, 2}}, {{0, 1}, {1, 1}}, {{0, 2}, {1, 1}}};
  const std::string eecbs = "Agent 0: (0,0)->(0,1)->(0,2)->\nAgent 1: (1,2)->(1,1)->\n";
  const std::string lns = "Agent 0:(0,0)->(0,1)->(0,2)->\nAgent 1:(1,2)->(1,1)\n";
  EXPECT_EQ(plan, load(eecbs, PlanFormat::Paths).value());
  EXPECT_EQ(plan, load(lns, PlanFormat::Paths).value());
}

TEST_F(SolverPlanFileTest, NamesTheLineThatIsWrongInAFileOfPaths) {
  const auto expect = [&](const std::string& error, const std::string& content) {
    expectRefused(error, content, PlanFormat::Paths);
  };
  const std::string form = " here, a line is 'Agent N:(row,col)->(row,col)->'";
  expect(": is empty, must start with 'Agent 0:(row,col)->'", "");
  expect(":1: 'Agent 1:(0,0)->': must be 'Agent 0:'" + form, "Agent 1:(0,0)->\n");
  expect(":2: 'Agent 0:(1,0)->': must be 'Agent 1:'" + form, "Agent 0:(0,0)->\nAgent 0:(1,0)->\n");
  expect(":2: agent 1 has no cell", "Agent 0:(0,0)->\nAgent 1:\n");
  expect(":1: ',(0,1)': must be '->'" + form, "Agent 0:(0,0),(0,1)\n");
  expect(":1: '': must be ','" + form, "Agent 0:(0,0)->(0");
}

TEST_F(SolverPlanFileTest, AFewPathsThatMakeAPlanWithoutEndAreRefused) {
  std::string paths = "Agent 0:";
  for (int step = 0; step < 20000; ++step) {
    paths += "(0,0)->";
  }
  for (int agent = 1; agent < 20000; ++agent) {
    paths += "\nAgent " + std::to_string(agent) + ":(0,0)";
  }
  expectRefused(": 19999 steps of 20000 agents: is too large", paths, PlanFormat::Paths);
}

}  // namespace
}  // namespace sylph
