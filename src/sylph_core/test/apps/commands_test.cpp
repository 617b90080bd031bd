// Runs the commands as a user does and looks at their exit status and output.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/mapf/scenario_file.hpp"
#include "sylph_core/planners/planner.hpp"
#include "test/support/ended_process.hpp"
#include "test/support/random_weights.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

struct CommandResult {
  int status = -1;
  std::string output;  // standard output and standard error
};

CommandResult runLine(const std::string& line) {
  FILE* pipe = popen((line + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    throw std::runtime_error("cannot run " + line);
  }
  CommandResult result;
  std::array<char, 4096> buffer{};
  while (const std::size_t read = fread(buffer.data(), 1, buffer.size(), pipe)) {
    result.output.append(buffer.data(), read);
  }
  result.status = WEXITSTATUS(pclose(pipe));
  return result;
}

CommandResult run(const std::string& command) {
  return runLine(std::string(COMMANDS_DIR) + "/sylph_" + command);
}

class CommandsTest : public ::testing::Test {
 protected:
  /// Expects exit status 2 and one line, "sylph_<command>: ... <error>".
  static void expectRefused(const std::string& error, const std::string& command) {
    const CommandResult refused = run(command);
    EXPECT_EQ(2, refused.status) << command;
    const std::string name = "sylph_" + command.substr(0, command.find(' '));
    EXPECT_EQ(0U, refused.output.rfind(name + ": ", 0)) << refused.output;
    EXPECT_EQ(refused.output.find('\n'), refused.output.size() - 1) << refused.output;
    EXPECT_NE(std::string::npos, refused.output.find(error)) << refused.output;
  }

  std::string instance(int agents = 2) const {
    return " --map " + map_ + " --scen " + scenario_ + " --agents " + std::to_string(agents);
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("a.map", "type octile\nheight 2\nwidth 3\nmap\n...\n..@\n");
  std::string scenario_ =
      folder_.write("a.scen", "version 1\n0 a.map 3 2 0 0 2 0 2\n0 a.map 3 2 2 0 0 0 2\n");
};

TEST_F(CommandsTest, PlanPrintsOneLineOfJsonAndWritesAPlanThatCheckAccepts) {
  const std::string plan = folder_.path("plan.txt");
  const CommandResult planned = run("plan" + instance() + " --first --json --plan " + plan);
  ASSERT_EQ(0, planned.status) << planned.output;
  EXPECT_EQ(planned.output.find('\n'), planned.output.size() - 1);
  const auto line = nlohmann::ordered_json::parse(planned.output);
  std::vector<std::string> keys;
  for (const auto& item : line.items()) {
    keys.push_back(item.key());
  }
  EXPECT_EQ(
      (std::vector<std::string>{"solved", "planner", "agents", "steps", "makespan", "sum_of_costs",
                                "sum_of_costs_lower_bound", "proved_sum_of_costs", "arrived",
                                "seconds_to_first", "seconds", "policy_calls"}),
      keys);
  EXPECT_TRUE(line["solved"].get<bool>());
  EXPECT_EQ(2, line["agents"].get<int>());
  EXPECT_EQ(2, line["arrived"].get<int>());
  EXPECT_EQ(4, line["sum_of_costs_lower_bound"].get<int>());
  EXPECT_GE(line["sum_of_costs"].get<int>(), 5);  // one has to step aside
  EXPECT_LE(line["seconds_to_first"].get<double>(), line["seconds"].get<double>());
  EXPECT_TRUE(line["proved_sum_of_costs"].is_null()) << "a first solution proves nothing";

  const CommandResult checked = run("check" + instance() + " " + plan);
  EXPECT_EQ(0, checked.status) << checked.output;
  EXPECT_EQ(0U, checked.output.rfind("valid: 2 agents, ", 0)) << checked.output;
}

TEST_F(CommandsTest, PlanWritesPartnersAndSvosOfEachStep) {
  const std::string social = folder_.path("social.csv");
  const std::string weights = folder_.path("w.safetensors");
  saveTensorFile(RandomWeights(smallShape(), 1).file(), weights);
  const CommandResult planned = run("plan" + instance() + " --planner sylph_lacam --weights " +
                                    weights + " --first --json --social " + social);
  ASSERT_EQ(0, planned.status) << planned.output;
  const int steps = nlohmann::json::parse(planned.output)["steps"].get<int>();
  std::ifstream file(social);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ("step,agent,row,col,partner,svo_deg", line);
  std::getline(file, line);
  EXPECT_EQ(0U, line.rfind("0,0,0,0,1,", 0))
      << line << ": agent 0 starts at (0,0), 1 is in its way";
  int lines = 1;
  while (std::getline(file, line)) {
    ++lines;
    const double svo_deg = std::stod(line.substr(line.rfind(',') + 1));
    EXPECT_TRUE(0.0 <= svo_deg && svo_deg <= 45.0) << line;
  }
  EXPECT_EQ(2 * steps, lines);
}

TEST_F(CommandsTest, APlanThatIsTooLongCountsUpToTheStepLimit) {
  const CommandResult planned = run("plan" + instance() + " --first --max-steps 1");
  EXPECT_EQ(1, planned.status);
  EXPECT_NE(std::string::npos, planned.output.find("step limit, 0 of 2 agents arrived\nsteps 1,"))
      << planned.output;
}

TEST_F(CommandsTest, PlanSpendsNothingOnSocialStates) {
  Rng rng(1);
  const Instance crowd = randomInstance(Grid(4, 4), 8, {}, rng);
  saveMap(crowd.grid, folder_.path("crowd.map"));
  saveScenario(crowd, "crowd.map", folder_.path("crowd.scen"));
  saveTensorFile(RandomWeights(smallShape(), 1).file(), folder_.path("w.safetensors"));
  PlanningLimits limits;
  limits.time_limit_s = 1000.0;
  limits.first_solution_only = true;
  const auto callsWith = [&](bool social_states) {
    limits.social_states = social_states;
    Rng seed(7);
    return makePlanner("sylph_lacam", randomPolicy())
        ->plan(crowd, limits, seed)
        .statistics.policy_calls;
  };
  ASSERT_LT(callsWith(false), callsWith(true)) << "the instance tells nothing";
  const CommandResult planned =
      run("plan --planner sylph_lacam --weights " + folder_.path("w.safetensors") + " --map " +
          folder_.path("crowd.map") + " --scen " + folder_.path("crowd.scen") +
          " --agents 8 --first --seed 7 --time-limit 1000 --json");
  ASSERT_EQ(0, planned.status) << planned.output;
  EXPECT_EQ(callsWith(false), nlohmann::json::parse(planned.output)["policy_calls"].get<long>());
}

TEST_F(CommandsTest, TheSameSeedGivesTheSameFirstPlan) {
  const auto planWith = [&](const std::string& name) {
    EXPECT_EQ(0,
              run("plan" + instance() + " --first --seed 3 --plan " + folder_.path(name)).status);
    return run("check" + instance() + " " + folder_.path(name)).output;
  };
  EXPECT_EQ(planWith("first.txt"), planWith("second.txt"));
}

TEST_F(CommandsTest, CheckRefusesPlansThatDoNotSolveTheScenario) {
  const auto expectViolation = [&](const std::string& message, const std::string& plan) {
    const CommandResult checked = run("check" + instance() + " " + folder_.write("plan.txt", plan));
    EXPECT_EQ(1, checked.status);
    EXPECT_EQ("refused: " + message + "\n", checked.output);
  };
  expectViolation("step 0: agent 0 at (0,0) instead of its goal (0,2)", "0: (0,0) (0,2)\n");
  expectViolation("step 1: agent 1 at (0,1), where agent 0 is too",
                  "0: (0,0) (0,2)\n1: (0,1) (0,1)\n");
  expectViolation("step 1: agent 1 at (1,2), which is not a free cell",
                  "0: (0,0) (0,2)\n1: (0,1) (1,2)\n");
  expectViolation("step 0: 1 agents instead of 2", "0: (0,0)\n");
}

TEST_F(CommandsTest, RotationsAreRefusedUnlessAskedFor) {
  const std::string map = folder_.write("r.map", "type octile\nheight 2\nwidth 2\nmap\n..\n..\n");
  const std::string scenario = folder_.write(
      "r.scen",
      "version 1\n0 r.map 2 2 0 0 1 0 1\n0 r.map 2 2 1 0 1 1 1\n0 r.map 2 2 1 1 0 1 1\n"
      "0 r.map 2 2 0 1 0 0 1\n");
  const std::string plan =
      folder_.write("r.txt", "0: (0,0) (0,1) (1,1) (1,0)\n1: (0,1) (1,1) (1,0) (0,0)\n");
  const std::string rotation = " --map " + map + " --scen " + scenario + " --agents 4 ";
  EXPECT_EQ("refused: step 1: agents 0, 1, 2, 3 rotate\n", run("check" + rotation + plan).output);
  EXPECT_EQ(0, run("check --rotations" + rotation + plan).status);
  EXPECT_EQ(0, run("plan --rotations --first" + rotation).status);
  // Four agents on four cells: without rotations nobody can move.
  const CommandResult stuck = run("plan --json --time-limit 0.5" + rotation);
  EXPECT_EQ(1, stuck.status);
  const auto line = nlohmann::json::parse(stuck.output);
  EXPECT_FALSE(line["solved"].get<bool>());
  EXPECT_TRUE(line["seconds_to_first"].is_null());
}

TEST_F(CommandsTest, BadOptionsAreOneLineAndStatusTwo) {
  expectRefused("--map is required", "plan");
  expectRefused("--agents", "plan" + instance(0));
  expectRefused("has 2 agents, asked for 3", "plan" + instance(3));
  expectRefused("--planner: astar not in {", "plan --planner astar" + instance());
  expectRefused("--weights: planner 'lacam' takes none",
                "plan --planner lacam --weights w.safetensors" + instance());
  for (const std::string time : {"0", "-1", "nan", "inf", "soon"}) {
    expectRefused("--time-limit: " + time + ": must be a number of seconds > 0",
                  "plan --time-limit=" + time + instance());
  }
  expectRefused("--threads: Value 0 not in range 1 to", "plan --threads 0" + instance());
  expectRefused("--max-steps", "plan --max-steps many" + instance());
  expectRefused("--fast", "plan --fast" + instance());
  expectRefused("PLAN is required", "check" + instance());
  expectRefused("cannot be written", "plan --first --plan /nowhere/plan.txt" + instance());
}

TEST_F(CommandsTest, BadFilesAreOneLineAndStatusTwo) {
  const std::string good_map = map_;
  const auto expectMap = [&](const std::string& error, const std::string& content) {
    map_ = folder_.write("bad.map", content);
    expectRefused("/bad.map" + error, "plan" + instance());
    map_ = good_map;
  };
  expectMap(": is empty", "");
  expectMap(":5: 1 rows: height says 2", "type octile\nheight 2\nwidth 3\nmap\n...\n");
  expectMap(":1: 'type tile': must be 'type octile'", "type tile\n");
  expectMap(":2: height '100000': must be a whole number 1 ... 8192",
            "type octile\nheight 100000\nwidth 3\nmap\n");

  const auto expectScenario = [&](const std::string& error, const std::string& lines) {
    scenario_ = folder_.write("bad.scen", lines);
    expectRefused("/bad.scen" + error, "plan" + instance());
  };
  expectScenario(": is empty", "");
  expectScenario(": has 1 agents, asked for 2", "version 1\n0 a.map 3 2 0 0 2 0 2\n");
  expectScenario(":3: start x '3': must be a whole number 0 ... 2",
                 "version 1\n0 a.map 3 2 0 0 2 0 2\n0 a.map 3 2 3 0 0 0 2\n");
  expectScenario(": start (0,0) of agent 1 is also the start of agent 0",
                 "version 1\n0 a.map 3 2 0 0 2 0 2\n0 a.map 3 2 0 0 0 0 2\n");
  expectScenario(": start (1,2) of agent 1 lies on an obstacle",
                 "version 1\n0 a.map 3 2 0 0 2 0 2\n0 a.map 3 2 2 1 0 0 2\n");

  map_ = folder_.write("split.map", "type octile\nheight 2\nwidth 3\nmap\n.@.\n.@.\n");
  expectScenario(": goal (0,2) of agent 0 cannot be reached from its start (0,0)",
                 "version 1\n0 a.map 3 2 0 0 2 0 2\n0 a.map 3 2 0 1 0 0 2\n");
}

TEST_F(CommandsTest, BadPlanFilesAreOneLineAndStatusTwo) {
  const auto expectPlan = [&](const std::string& error, const std::string& content) {
    expectRefused("/bad.txt" + error,
                  "check" + instance() + " " + folder_.write("bad.txt", content));
  };
  expectPlan(": is empty", "");
  expectPlan(":2: step 5: must be 1", "0: (0,0) (0,2)\n5: (0,0) (0,2)\n");
  expectPlan(":1: ' x': must be", "0 x");
  expectRefused("/none.txt: there is no such file",
                "check" + instance() + " " + folder_.path("none.txt"));
}

TEST_F(CommandsTest, PlannersWithAPolicyTakeWeights) {
  saveTensorFile(RandomWeights(smallShape(), 2).file(), folder_.path("w.safetensors"));
  const std::string weights = " --weights " + folder_.path("w.safetensors");
  const CommandResult planned =
      run("plan --planner sylph_lacam --first --json" + instance() + weights);
  ASSERT_EQ(0, planned.status) << planned.output;
  EXPECT_GT(nlohmann::json::parse(planned.output)["policy_calls"].get<int>(), 0);
  const std::string suite = folder_.write(
      "suite.yaml",
      "first: true\nmax_steps: 20\nfamilies: [{name: a, agents: [2], map: a.map, scenarios: "
      "[a.scen]}]\n");
  const CommandResult compared =
      run("benchmark " + suite + " --planner sylph --planner lacam" + weights);
  EXPECT_EQ(0, compared.status) << compared.output;
}

TEST_F(CommandsTest, WeightsAreFoundInTheSpaceAroundTheCommand) {
  namespace fs = std::filesystem;
  const fs::path command = folder_.path("lib/sylph_core/sylph_plan");
  fs::create_directories(command.parent_path());
  fs::copy_file(std::string(COMMANDS_DIR) + "/sylph_plan", command);
  const std::string arguments = " --planner sylph_pibt --json" + instance();
  const std::string without_packages = "env -u ROS_PACKAGE_PATH ";
  const CommandResult without = runLine(without_packages + command.string() + arguments);
  EXPECT_EQ(2, without.status);
  EXPECT_NE(std::string::npos, without.output.find("--weights is required by planner 'sylph_pibt'"))
      << without.output;
  fs::create_directories(folder_.path("share/sylph_bringup/weights"));
  saveTensorFile(RandomWeights(smallShape(), 2).file(),
                 folder_.path("share/sylph_bringup/weights/sylph.safetensors"));
  const CommandResult with = runLine(without_packages + command.string() + arguments);
  EXPECT_NE(2, with.status) << with.output;
  EXPECT_GT(nlohmann::json::parse(with.output)["policy_calls"].get<int>(), 0);
}

TEST_F(CommandsTest, BadWeightsAreOneLineAndStatusTwo) {
  const auto expectWeights = [&](const std::string& error) {
    const std::string weights = " --weights " + folder_.path("w.safetensors");
    expectRefused("/w.safetensors: " + error, "plan --planner sylph_pibt" + instance() + weights);
    const std::string suite = folder_.write(
        "suite.yaml", "families: [{name: a, agents: [1], map: a.map, scenarios: [a.scen]}]\n");
    expectRefused("/w.safetensors: " + error, "benchmark " + suite + " --planner sylph" + weights);
  };
  expectWeights("cannot be opened");
  folder_.write("w.safetensors", "nothing");
  expectWeights("");
  TensorFile file = RandomWeights(smallShape(), 2).file();
  file.metadata["channels"] = "9";
  saveTensorFile(file, folder_.path("w.safetensors"));
  expectWeights("metadata 'channels' is '9': must be '32'");
  file = RandomWeights(smallShape(), 2).file();
  file.tensors["goal.bias"].shape = {2, 2};
  saveTensorFile(file, folder_.path("w.safetensors"));
  expectWeights("tensor 'goal.bias' has the shape [2, 2]: must be [4]");
}

TEST_F(CommandsTest, GenerateMapWritesWhatPlanReads) {
  const std::string map = folder_.path("g.map");
  const std::string scenario = folder_.path("g.scen");
  for (const std::string family : {"random --density 0.1", "room --room-size 2", "maze"}) {
    const CommandResult generated =
        run("generate_map " + family + " --rows 9 --cols 12 --seed 2 --out " + map + " --scen " +
            scenario + " --agents 4");
    EXPECT_EQ(0, generated.status) << generated.output;
    const CommandResult planned =
        run("plan --first --map " + map + " --scen " + scenario + " --agents 4");
    EXPECT_EQ(0, planned.status) << planned.output;
  }
  expectRefused("density 1.500000: must be >= 0 and < 1",
                "generate_map random --density 1.5 --out " + map);
  expectRefused("grid of 0 x 32 cells", "generate_map maze --rows 0 --out " + map);
  expectRefused(
      "99 agents on a map of 1 free cells",
      "generate_map maze --rows 1 --cols 1 --agents 99 --out " + map + " --scen " + scenario);
}

TEST_F(CommandsTest, BenchmarkPrintsATableAndWritesCsv) {
  const std::string suite =
      folder_.write("suite.yaml",
                    "first: true\nfamilies:\n  - {name: stored, agents: [1, 2], map: a.map, "
                    "scenarios: [a.scen]}\n");
  const std::string csv = folder_.path("results.csv");
  const CommandResult result =
      run("benchmark " + suite + " --planner lacam --planner pibt --jobs 2 --out " + csv);
  EXPECT_EQ(0, result.status) << result.output;
  EXPECT_NE(std::string::npos, result.output.find("4 / 4 runs\n")) << result.output;
  EXPECT_NE(std::string::npos, result.output.find("stored  pibt          2     1     100.0"))
      << result.output;
  std::ifstream file(csv);
  int lines = 0;
  for (std::string line; std::getline(file, line);) {
    ++lines;
  }
  EXPECT_EQ(5, lines);
}

TEST_F(CommandsTest, BenchmarkRunsExternalSolversOnTheSameCases) {
  namespace fs = std::filesystem;
  const std::string solver = folder_.write(
      "solver", "#!/bin/sh\n\"$@\"; [ $? -eq 0 ] || { echo out of ideas; exit 9; }\n");
  fs::permissions(solver, fs::perms::owner_all);
  const auto benchmark = [&](const std::string& command) {
    const std::string suite = folder_.write(
        "suite.yaml",
        "first: true\nexternal:\n  - {name: other, command: \"" + command +
            "\"}\nfamilies:\n  - {name: stored, agents: [2], map: a.map, scenarios: [a.scen]}\n");
    return run("benchmark " + suite);
  };
  const CommandResult ours =
      benchmark("./solver " + std::string(COMMANDS_DIR) +
                "/sylph_plan --map {map} --scen {scen} --agents {agents} --time-limit {seconds} "
                "--first --plan {plan}");
  EXPECT_EQ(0, ours.status) << ours.output;
  EXPECT_NE(std::string::npos, ours.output.find("2 / 2 runs\n")) << ours.output;
  EXPECT_NE(std::string::npos, ours.output.find("stored  other         2     1     100.0        -"))
      << ours.output;
  EXPECT_NE(std::string::npos,
            ours.output.find("stored  other         2           1         1.000"))
      << ours.output;
  const CommandResult failed = benchmark("./solver false {plan}");
  EXPECT_EQ(1, failed.status);
  EXPECT_NE(std::string::npos,
            failed.output.find("sylph_benchmark: other on stored, instance 0, 2 agents: no plan, "
                               "exit status 9; its last lines: out of ideas\n"))
      << failed.output;
}

TEST_F(CommandsTest, AnExternalSolverEndsWithTheBenchmark) {
  namespace fs = std::filesystem;
  fs::permissions(folder_.write("solver", "#!/bin/sh\necho $$ > pid\nexec sleep 1000\n"),
                  fs::perms::owner_all);
  const std::string suite = folder_.write(
      "suite.yaml",
      "first: true\ntime_limit_s: 1000\nexternal: [{name: a, command: \"./solver {plan}\"}]\n"
      "families: [{name: a, agents: [1], map: a.map, scenarios: [a.scen]}]\n");
  const std::string pid = folder_.path("pid");
  // The signal is for the benchmark alone, as Ctrl-C in a terminal is.
  runLine("(cd " + folder_.path("") + "; TMPDIR=$PWD " + COMMANDS_DIR + "/sylph_benchmark " +
          suite + " & until [ -s pid ] || ! kill -0 $!; do sleep 0.01; done; kill $!; wait $!)");
  EXPECT_TRUE(endsSoon(pid));
}

TEST_F(CommandsTest, BadSuitesAreOneLineAndStatusTwo) {
  const auto expectSuite = [&](const std::string& error, const std::string& content,
                               const std::string& options = "") {
    expectRefused(error, "benchmark " + folder_.write("bad.yaml", content) + options);
  };
  const std::string good = "families: [{name: a, agents: [1], map: a.map, scenarios: [a.scen]}]\n";
  expectSuite("/bad.yaml: is empty, must be a YAML mapping", "");
  expectSuite("/bad.yaml:2: is not YAML: ", "families:\n  - {name");
  expectSuite("/bad.yaml:2: family: unknown key", good + "family: a\n");
  expectSuite("/b.map: there is no such file",
              "families: [{name: a, agents: [1], map: b.map, scenarios: [a.scen]}]\n");
  expectSuite("/bad.yaml:2: external[0].command: there is no program 'no-such-solver' on the PATH",
              good + "external: [{name: a, command: \"no-such-solver {plan}\"}]\n");
  expectSuite("--planner: astar not in {", good, " --planner astar");
  expectSuite("--jobs: Value 0 not in range", good, " --jobs 0");
  expectSuite("/nowhere/a.csv: cannot be written: No such file or directory", good,
              " --out /nowhere/a.csv");
  expectRefused("SUITE is required", "benchmark");
}

}  // namespace
}  // namespace sylph
