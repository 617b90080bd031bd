// Whatever happens to a file, its reader answers: with a value, or with one line.

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "sylph_core/benchmark/suite.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/plan_file.hpp"
#include "sylph_core/mapf/scenario_file.hpp"
#include "sylph_core/mapf/solver_plan_file.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

const char kMap[] = "type octile\nheight 3\nwidth 4\nmap\n..@.\n.@..\n....\n";
const char kScenario[] =
    "version 1\n0\ta.map\t4\t3\t0\t0\t3\t2\t5\n0\ta.map\t4\t3\t3\t2\t0\t0\t5\n";
const char kPlan[] = "0: (0,0) (2,3)\n1: (1,0) (2,2)\n2: (1,0) (2,1)\n";
const char kLacamPlan[] = "agents=2\nsolved=1\nsolution=\n0:(0,0),(2,1),\n1:(1,0),(2,1),\n";
const char kPaths[] = "Agent 0: (0,0)->(0,1)->\nAgent 1: (1,2)->(1,1)->(1,0)->\n";
const char kMapServer[] =
    "image: m.pgm\nresolution: 0.3\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";
const char kExperiment[] =
    "map: a.map\nseed: 3\ngoals: random\nrobots:\n  - {name: robot_0, start: [0, 0]}\n"
    "  - {name: robot_1, footprint_m: [0.2, 0.1], start: [2, 3]}\n"
    "planning: {time_limit_s: 2.5}\nexecution: {speed_limit_mps: 0.4}\n";
const char kSuite[] =
    "first: true\nexternal: [{name: b, command: \"c -m {map} {plan}\", plan_format: lacam}]\n"
    "families:\n  - {name: a, agents: [3, 5], generator: maze, rows: 9}\n"
    "  - {name: b, agents: [1], map: a.map, scenarios: [a.scen]}\n";

/// Cuts the text, or puts other characters into it, takes them out or doubles them.
std::string mutated(std::string text, Rng& rng) {
  const std::string spice = std::string("0-9.:,[]{}()\"'&*!|>%#\n\t\r@T \xFF") + '\0';
  const std::size_t changes = 1 + drawIndex(rng, 4);
  for (std::size_t change = 0; change < changes && !text.empty(); ++change) {
    const std::size_t place = drawIndex(rng, text.size());
    switch (drawIndex(rng, 5)) {
      case 0:
        text[place] = spice[drawIndex(rng, spice.size())];
        break;
      case 1:
        text.insert(place, 1 + drawIndex(rng, 3), spice[drawIndex(rng, spice.size())]);
        break;
      case 2:
        text.erase(place, 1 + drawIndex(rng, 5));
        break;
      case 3:
        text.insert(place, text.substr(drawIndex(rng, text.size()), drawIndex(rng, 20)));
        break;
      default:
        text.resize(place);
    }
  }
  return text;
}

/// Mutates one file many times and reads it each time; errorOf() expects the error to be one line,
/// and any other exception ends the test.
void expectAnswers(const TemporaryFolder& folder, const std::string& name,
                   const std::string& content, const std::function<void()>& read) {
  EXPECT_EQ("", errorOf(read));
  int refused = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    Rng rng(seed);
    folder.write(name, mutated(content, rng));
    refused += errorOf(read).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 100) << name;
  folder.write(name, content);
}

TEST(MutationProperty, EveryReaderAnswersInOneLine) {
  const TemporaryFolder folder;
  const std::string pgm =
      std::string("P5\n# made by hand\n3 2\n255\n") + std::string("\xFE\x00\xFE\xFE\xFE\xCD", 6);
  const std::string map = folder.write("a.map", kMap);
  const std::string scenario = folder.write("a.scen", kScenario);
  const std::string plan = folder.write("plan.txt", kPlan);
  const std::string lacam = folder.write("lacam.txt", kLacamPlan);
  const std::string paths = folder.write("paths.txt", kPaths);
  const std::string map_server = folder.write("m.yaml", kMapServer);
  const std::string experiment = folder.write("lab.yaml", kExperiment);
  const std::string suite = folder.write("suite.yaml", kSuite);
  folder.write("m.pgm", pgm);
  expectAnswers(folder, "a.map", kMap, [&] { loadMap(map); });
  expectAnswers(folder, "a.scen", kScenario, [&] { loadScenario(scenario, loadMap(map), 2); });
  expectAnswers(folder, "plan.txt", kPlan, [&] { loadPlan(plan); });
  expectAnswers(folder, "lacam.txt", kLacamPlan, [&] { loadSolverPlan(lacam, PlanFormat::Lacam); });
  expectAnswers(folder, "paths.txt", kPaths, [&] { loadSolverPlan(paths, PlanFormat::Paths); });
  expectAnswers(folder, "m.yaml", kMapServer, [&] { loadMap(map_server); });
  expectAnswers(folder, "m.pgm", pgm, [&] { loadMap(map_server); });
  expectAnswers(folder, "lab.yaml", kExperiment, [&] { loadExperiment(experiment); });
  expectAnswers(folder, "suite.yaml", kSuite, [&] { loadSuite(suite); });
}

TEST(MutationTest, YamlBehindTheFirstDocumentIsRefused) {
  const TemporaryFolder folder;
  for (const std::string rest : {"}\n", "]\n", "---\nmap: b.map\n"}) {
    const std::string path = folder.write("lab.yaml", "map: a.map\n" + rest);
    EXPECT_NE("", errorOf([&] { loadExperiment(path); }));
    EXPECT_EQ(std::string::npos, errorOf([&] { loadExperiment(path); }).find("robots")) << rest;
  }
}

TEST(MutationTest, YamlWithAnUnknownEscapeIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const std::string path = folder.write("lab.yaml", "map: \"a\\\rb\"\n");
  expectError("lab.yaml:1: is not YAML: unknown escape character: ?",
              [&] { loadExperiment(path); });
}

TEST(MutationTest, AnErrorIsOneLineWhateverAFileIsCalled) {
  const TemporaryFolder folder;
  const std::string path = folder.write("lab.yaml", "map: \"a\\nb.map\"\n");
  expectError("a?b.map: there is no such file", [&] { loadExperiment(path); });
}

TEST(MutationTest, DeeplyNestedYamlIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("lab.yaml", "map: " + std::string(500'000, '['));
  EXPECT_NE(std::string::npos, errorOf([&] { loadExperiment(path); }).find("is not YAML"));
}

}  // namespace
}  // namespace sylph
