#include "sylph_rehearsal/seeds.hpp"

#include <charconv>
#include <stdexcept>
#include <system_error>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/random_instance.hpp"

namespace sylph_rehearsal {
namespace {

/// Other draws than those of an experiment with the same seed.
constexpr std::uint32_t kMoreRobotsPart = 3000;

}  // namespace

SeedRange seedsFromText(const std::string& text) {
  const char* const end = text.data() + text.size();
  SeedRange seeds;
  auto [rest, error] = std::from_chars(text.data(), end, seeds.first);
  seeds.last = seeds.first;
  if (error == std::errc() && rest != end && *rest == '-') {
    const auto last = std::from_chars(rest + 1, end, seeds.last);
    rest = last.ptr;
    error = last.ec;
  }
  if (error != std::errc() || rest != end || seeds.last < seeds.first) {
    throw std::invalid_argument("seeds '" + text +
                                "': must be A or A-B with whole numbers 0 <= A <= B");
  }
  return seeds;
}

sylph::Experiment experimentOf(const std::string& path, std::uint32_t seed, int robots) {
  sylph::Experiment experiment = sylph::loadExperiment(path, {seed, {}, {}});
  const auto wanted = static_cast<std::size_t>(robots);
  if (robots == 0 || wanted == experiment.robots.size()) {
    return experiment;
  }
  if (wanted < experiment.robots.size()) {
    experiment.robots.resize(wanted);
    return experiment;
  }
  std::seed_seq sequence{seed, kMoreRobotsPart};
  sylph::Rng rng(sequence);
  const sylph::Instance instance =
      sylph::randomInstance(experiment.grid, robots, sylph::MotionModel{false}, rng);
  const sylph::RobotSpec pattern = experiment.robots.back();
  experiment.robots.resize(wanted, pattern);
  for (std::size_t robot = 0; robot < wanted; ++robot) {
    sylph::RobotSpec& spec = experiment.robots[robot];
    spec.name = "robot_" + std::to_string(robot);
    spec.rigid_body = spec.name;
    spec.start = instance.starts[robot];
    spec.goal = instance.goals[robot];
  }
  return experiment;
}

}  // namespace sylph_rehearsal
