#include "rehearsal_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <regex>
#include <string>
#include <vector>

#include "histogram.hpp"
#include "open_lab.hpp"
#include "sylph_core/grid/rng.hpp"

namespace sylph_rehearsal {
namespace {

/// What the bars of a page count, in order.
std::vector<int> barCounts(const std::string& page) {
  const std::regex bar("<title>([0-9]+) ");
  std::vector<int> counts;
  for (std::sregex_iterator match(page.begin(), page.end(), bar), end; match != end; ++match) {
    counts.push_back(std::stoi((*match)[1]));
  }
  return counts;
}

bool has(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

Rehearsal runOf(std::uint32_t seed, Ending ending, const std::string& cause = "") {
  Rehearsal run;
  run.seed = seed;
  run.ending = ending;
  run.cause = cause;
  run.result.execution_s = 20.0 + seed;
  run.result.ideal_execution_s = 20.0;
  run.result.min_separation_m = 0.06;
  return run;
}

TEST(RehearsalPageTest, CountsEndingsCausesAndFaults) {
  std::vector<Rehearsal> runs = {runOf(1, Ending::Finished),
                                 runOf(2, Ending::Stopped, "robot_3: no report for 30.2 s"),
                                 runOf(3, Ending::Stopped, "robot_12: no report for 31.0 s"),
                                 runOf(4, Ending::Violated, "two robots touch")};
  runs[1].faults = {faultOf(LabFaultKind::CrashRobot, {3}, 1.0, kForGood)};
  runs[3].faults = {faultOf(LabFaultKind::CrashRobot, {3}, 1.0, kForGood)};
  const std::string page = toPage(openLab(2, 2, {{{0, 0}, {0, 1}}}), runs);
  EXPECT_TRUE(has(page, "1 robots, 4 runs, seeds 1 to 4."));
  EXPECT_TRUE(
      has(page, "<td>stopped</td><td class=\"number\">2</td><td class=\"number\">50.0</td>"));
  EXPECT_TRUE(
      has(page, "<td>robot_N: no report for N s</td><td>2, 3</td><td class=\"number\">2</td>"));
  EXPECT_TRUE(has(page, "<td>two robots touch</td><td>4</td><td class=\"number\">1</td>"));
  EXPECT_TRUE(has(page,
                  "<td>crash_robot</td><td class=\"number\">2</td><td class=\"number\">0</td>"
                  "<td class=\"number\">1</td><td class=\"number\">1</td>"));
  EXPECT_FALSE(has(page, "Emergency stops"));
}

TEST(RehearsalPageTest, ShowsBrakingBesideWhatTheMonitorReckonsWith) {
  std::vector<Rehearsal> runs = {runOf(1, Ending::Stopped, "stop")};
  runs[0].brakings = {{0, 0.25, 0.05, 0.4}, {0, 0.2, 0.04, 0.3}};
  const std::string page = toPage(openLab(2, 2, {{{0, 0}, {0, 1}}}), runs);
  EXPECT_TRUE(has(page, "Emergency stops"));
  EXPECT_TRUE(has(page, "reckoned at the speed limit"));
  EXPECT_TRUE(has(page, "<td>braking [mm]</td><td class=\"number\">40.00</td>"));
}

TEST(RehearsalPageTest, IsHtmlWhateverCausesAndNamesHold) {
  sylph::Experiment experiment = openLab(2, 2, {{{0, 0}, {0, 1}}});
  experiment.name = "a<b>&\"c\"";
  const std::string page = toPage(experiment, {runOf(1, Ending::Stopped, "<script>x</script>")});
  EXPECT_FALSE(has(page, "<script"));
  EXPECT_TRUE(has(page, "&lt;script&gt;x&lt;/script&gt;"));
  EXPECT_TRUE(has(page, "<title>a&lt;b&gt;&amp;&quot;c&quot;, rehearsed</title>"));
}

TEST(HistogramTest, CountsEveryValueInOneBar) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    sylph::Rng rng(seed);
    const double center = sylph::drawBetween(rng, -1e3, 1e3);
    const double spread = std::pow(10.0, sylph::drawBetween(rng, -6.0, 4.0));
    std::vector<double> values(1 + sylph::drawIndex(rng, 500));
    for (double& value : values) {
      value = center + spread * sylph::drawNormal(rng);
    }
    std::sort(values.begin(), values.end());
    const std::vector<int> counts = barCounts(histogramSvg(values, "x [m]", "runs"));
    EXPECT_EQ(values.size(), std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
    EXPECT_LE(counts.size(), 52U);
  }
}

TEST(HistogramTest, DrawsOneBarWhereAllAreTheSame) {
  EXPECT_EQ((std::vector<int>{7}),
            barCounts(histogramSvg(std::vector<double>(7, 70.98), "x [mm]", "runs")));
  EXPECT_EQ((std::vector<int>{7}),
            barCounts(histogramSvg(std::vector<double>(7, 0.0), "x", "runs")));
}

TEST(HistogramTest, MakesRoomForItsMark) {
  const std::string svg = histogramSvg({60.0, 61.0}, "x", "runs", HistogramMark{18.0, "limit"});
  EXPECT_NE(std::string::npos, svg.find(">limit</text>"));
  EXPECT_NE(std::string::npos, svg.find(">20</text>")) << "the axis reaches down to the mark";
}

}  // namespace
}  // namespace sylph_rehearsal
