#include "sylph_core/benchmark/suite.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "sylph_core/benchmark/run_benchmark.hpp"
#include "sylph_core/text/join.hpp"
#include "test/support/random_weights.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

const char kSuite[] = R"(planners: [pibt, lacam]
time_limit_s: 2
rotations: true
families:
  - {name: rooms, agents: [3, 5], instances: 4, seed: 9, generator: room, rows: 9, cols: 12}
  - {name: stored, agents: [1, 2], map: a.map, scenarios: [a.scen]}
)";

class SuiteTest : public ::testing::Test {
 protected:
  SuiteTest() {
    folder_.write("a.map", "type octile\nheight 2\nwidth 3\nmap\n...\n...\n");
    folder_.write("a.scen", "version 1\n0 a.map 3 2 0 0 2 0 2\n0 a.map 3 2 2 0 0 0 2\n");
  }

  std::string write(const std::string& content) const {
    return folder_.write("suite.yaml", content);
  }

  void expectRefused(const std::string& error, const std::string& from,
                     const std::string& to) const {
    std::string text = kSuite;
    const std::size_t position = text.find(from);
    ASSERT_NE(std::string::npos, position) << from;
    text.replace(position, from.size(), to);
    expectError("/suite.yaml" + error, [&] { loadSuite(write(text)); });
  }

  TemporaryFolder folder_;
};

TEST_F(SuiteTest, ReadsEveryField) {
  const BenchmarkSuite suite = loadSuite(write(kSuite));
  EXPECT_EQ((std::vector<std::string>{"pibt", "lacam"}), suite.planners);
  EXPECT_DOUBLE_EQ(2.0, suite.limits.time_limit_s);
  EXPECT_FALSE(suite.limits.first_solution_only);
  EXPECT_TRUE(suite.motion.rotations);
  ASSERT_EQ(2U, suite.families.size());
  const auto& generated = std::get<GeneratedInstances>(suite.families[0].source);
  EXPECT_EQ(4, generated.instances);
  EXPECT_EQ(9U, generated.seed);
  EXPECT_EQ(12, std::get<RoomMapSpec>(generated.map).cols);
  EXPECT_EQ(3, std::get<RoomMapSpec>(generated.map).room_size);
  const auto& stored = std::get<StoredInstances>(suite.families[1].source);
  EXPECT_EQ(folder_.path("a.map"), stored.map_path);
  EXPECT_EQ((std::vector<std::string>{folder_.path("a.scen")}), stored.scenario_paths);
}

TEST_F(SuiteTest, FewerAgentsAreTheFirstOfMore) {
  const std::vector<BenchmarkCase> cases = makeCases(loadSuite(write(kSuite)));
  ASSERT_EQ(4U * 2U + 2U, cases.size());
  EXPECT_EQ(3, cases[0].instance.agentCount());
  EXPECT_EQ(5, cases[1].instance.agentCount());
  EXPECT_EQ(cases[0].instance.grid, cases[1].instance.grid);
  EXPECT_EQ(cases[0].instance.goals[2], cases[1].instance.goals[2]);
  EXPECT_NE(cases[1].instance.grid, cases[3].instance.grid);  // the next instance
  EXPECT_EQ(3, cases[7].instance_number);
  EXPECT_EQ("stored", cases[8].family);
}

TEST_F(SuiteTest, NamesTheFieldThatIsWrong) {
  expectRefused(
      ":1: planner: unknown key, must be one of planners, ablations, time_limit_s, max_steps, "
      "first, "
      "rotations, external, families",
      "planners", "planner");
  expectRefused(":2: time_limit_s: is '0', must be a number > 0", "s: 2", "s: 0");
  expectRefused(":3: rotations: is 'maybe', must be one of true, false", "true", "maybe");
  expectRefused(":5: families[0].agents: is '0', must be a whole number 1 ... 1000000", "3, 5",
                "0, 5");
  expectRefused(":5: families[0].agents: is empty, must be a list of whole numbers", "3, 5", "");
  expectRefused(":5: families[0].generator: is 'cave', must be one of random, room, maze",
                "generator: room", "generator: cave");
  expectRefused(
      ":5: families[0].density: unknown key, must be one of name, agents, generator, "
      "map, rows, cols, room_size, door_width, door_share, instances, seed",
      "rows: 9", "density: 0.2");
  expectRefused(":5: families[0].rows: is '9000', must be a whole number 1 ... 8192", "rows: 9",
                "rows: 9000");
  expectRefused(":6: families[1].name: 'rooms' is another family's too", "stored", "rooms");
  expectRefused(":6: families[1].generator: a family needs either 'generator' or 'map'",
                "map: a.map, ", "");
  expectRefused(":6: families[1].scenarios: is empty, must be a list of texts", "[a.scen]", "[]");
  expectError("/suite.yaml: is empty, must be a YAML mapping", [&] { loadSuite(write("")); });
  expectError("/none.yaml: there is no such file", [&] { loadSuite(folder_.path("none.yaml")); });
}

TEST_F(SuiteTest, RefusesInstancesThatCannotBe) {
  expectError("/a.scen: has 2 agents, asked for 3", [&] {
    makeCases(loadSuite(
        write("families:\n  - {name: a, agents: [3], map: a.map, scenarios: [a.scen]}\n")));
  });
  try {
    makeCases(loadSuite(
        write("families:\n  - {name: a, agents: [9], generator: random, rows: 2, cols: 2}\n")));
    ADD_FAILURE() << "nine agents fit on three cells";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ("family 'a': 9 agents on a map of 3 free cells", error.what());
  }
}

TEST_F(SuiteTest, RunsGiveTheSamePlansHoweverManyAtATime) {
  BenchmarkSuite suite = loadSuite(write(kSuite));
  suite.limits.first_solution_only = true;
  const std::vector<BenchmarkCase> cases = makeCases(suite);
  std::size_t told = 0;
  const auto runWith = [&](int jobs) {
    told = 0;
    return runBenchmark(suite, cases, nullptr, jobs,
                        [&](const BenchmarkRun& run, std::size_t done) {
                          EXPECT_GT(run.agents, 0);
                          EXPECT_EQ(told + 1, done);
                          told = done;
                        });
  };
  const auto one = runWith(1);
  const auto three = runWith(3);
  EXPECT_EQ(2 * cases.size(), told);
  ASSERT_EQ(2 * cases.size(), one.size());
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t index = 0; index < one.size(); ++index) {
    EXPECT_EQ(one[index].planner, three[index].planner);
    EXPECT_EQ(one[index].agents, three[index].agents);
    EXPECT_EQ(one[index].evaluation.metrics.sum_of_costs,
              three[index].evaluation.metrics.sum_of_costs);
  }
}

TEST_F(SuiteTest, PlannersTakeTurnsAndRunsComeInOrder) {
  BenchmarkSuite suite = loadSuite(write(kSuite));
  suite.limits.first_solution_only = true;
  const std::vector<BenchmarkCase> cases = makeCases(suite);
  const auto nameOf = [](const BenchmarkRun& run) {
    return run.planner + std::to_string(run.agents);
  };
  std::vector<std::string> ended;
  const auto runs =
      runBenchmark(suite, {cases[8], cases[9]}, nullptr, 1,
                   [&](const BenchmarkRun& run, std::size_t) { ended.push_back(nameOf(run)); });
  EXPECT_EQ("pibt1, lacam1, pibt2, lacam2", join(ended));
  EXPECT_EQ("pibt1, pibt2, lacam1, lacam2", join(runs, ", ", nameOf));
}

TEST_F(SuiteTest, PolicyGuidedPlannersRunWithEachAblation) {
  BenchmarkSuite suite = loadSuite(
      write("planners: [pibt, sylph]\nablations: [random_svo_per_step, svo_by_priority]\n"
            "max_steps: 5\nfamilies: [{name: s, agents: [2], map: a.map, scenarios: [a.scen]}]\n"));
  const auto runs = runBenchmark(suite, makeCases(suite), randomPolicy(), 1,
                                 [](const BenchmarkRun&, std::size_t) {});
  EXPECT_EQ("pibt, sylph, sylph/random_svo_per_step, sylph/svo_by_priority",
            join(runs, ", ", [](const BenchmarkRun& run) { return run.planner; }));
  EXPECT_EQ(runs.size(), entrantCount(suite));
  expectRefused(":1: ablations: has 'no_svo', each must be one of " + join(ablationNames()),
                "planners: [pibt, lacam]", "ablations: [no_svo]");
}

BenchmarkRun exampleRun(int instance_number, bool is_solved, long sum_of_costs, double first_s) {
  BenchmarkRun run;
  run.planner = "lacam";
  run.family = "rooms";
  run.agents = 7;
  run.instance_number = instance_number;
  run.outcome = is_solved ? RunOutcome::Solved : RunOutcome::TimeLimit;
  run.evaluation.is_solved = is_solved;
  run.evaluation.metrics.sum_of_costs = sum_of_costs;
  run.evaluation.metrics.makespan = 12;
  run.evaluation.sum_of_costs_lower_bound = 100;
  run.statistics.first_solution_s = first_s;
  return run;
}

TEST(BenchmarkReportTest, TheTableSummarizesSolvedRuns) {
  const std::string table = toTable({exampleRun(0, true, 110, 0.5), exampleRun(1, true, 130, 0.25),
                                     exampleRun(2, false, 999, 0.0)});
  EXPECT_EQ(
      "family  planner  agents  runs  solved %  first s  p95 s  cost / bound  95 % interval  "
      "makespan\n"
      "rooms   lacam         7     3      66.7    0.250  0.500         1.200   1.100..1.300      "
      "12.0\n",
      table);
}

TEST(BenchmarkReportTest, OfExternalSolversNobodyKnowsTheFirstSolution) {
  BenchmarkRun run = exampleRun(0, true, 110, 0.0);
  run.is_external = true;
  EXPECT_EQ(
      "family  planner  agents  runs  solved %  first s  p95 s  cost / bound  95 % interval  "
      "makespan\n"
      "rooms   lacam         7     1     100.0        -      -         1.100              -      "
      "12.0\n",
      toTable({run}));
}

TEST(BenchmarkReportTest, PlannersAreComparedOnWhatBothSolve) {
  const auto by = [](const std::string& planner, BenchmarkRun run) {
    run.planner = planner;
    return run;
  };
  const std::vector<BenchmarkRun> first = {
      exampleRun(0, true, 100, 0.0), exampleRun(1, true, 200, 0.0), exampleRun(2, false, 999, 0.0)};
  EXPECT_EQ("", toRatioTable(first));
  std::vector<BenchmarkRun> runs = first;
  runs.push_back(by("pibt", exampleRun(0, true, 150, 0.0)));
  runs.push_back(by("pibt", exampleRun(1, true, 220, 0.0)));
  runs.push_back(by("pibt", exampleRun(2, true, 100, 0.0)));
  runs.push_back(by("none", exampleRun(0, false, 150, 0.0)));
  runs[4].agents = 9;  // another group, whose other run is not there
  runs.push_back(by("pibt", exampleRun(1, true, 220, 0.0)));
  EXPECT_EQ(
      "family  planner  agents  both solve  cost / lacam  95 % interval\n"
      "rooms   pibt          7           2         1.300   1.100..1.500\n"
      "rooms   none          7           0             -              -\n"
      "rooms   pibt          9           0             -              -\n"
      "rooms   none          9           0             -              -\n"
      "all     pibt                      2         1.300   1.100..1.500\n"
      "all     none                      0             -              -\n",
      toRatioTable(runs));
}

TEST(BenchmarkReportTest, TheCsvHasOneLineARun) {
  EXPECT_EQ(
      "planner,family,agents,instance,outcome,steps,makespan,sum_of_costs,"
      "sum_of_costs_lower_bound,arrived,seconds_to_first,seconds,policy_calls\n"
      "lacam,rooms,7,0," +
          toString(RunOutcome::Solved) +
          ",0,12,110,100,0,0.5,0,0\n"
          "lacam,rooms,7,1," +
          toString(RunOutcome::TimeLimit) + ",0,12,999,100,0,,0,0\n",
      toCsv({exampleRun(0, true, 110, 0.5), exampleRun(1, false, 999, 0.0)}));
}

TEST(ShippedSuitesTest, AllOfTheirCasesCanBeMade) {
  const std::string root = REPOSITORY_DIR;
  EXPECT_EQ(14U, makeCases(loadSuite(root + "/maps/benchmark/suite.yaml")).size());
  for (const auto& file : std::filesystem::directory_iterator(root + "/benchmarks")) {
    SCOPED_TRACE(file.path());
    EXPECT_LT(0U, makeCases(loadSuite(file.path())).size());
  }
}

}  // namespace
}  // namespace sylph
