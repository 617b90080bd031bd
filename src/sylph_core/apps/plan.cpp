// sylph_plan: plans one scenario.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "instance_options.hpp"
#include "sylph_core/benchmark/evaluation.hpp"
#include "sylph_core/command/run_command.hpp"
#include "sylph_core/mapf/plan_file.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/social/social_state_file.hpp"
#include "weights_option.hpp"

namespace {

struct Options {
  sylph::InstanceOptions instance;
  std::string planner = sylph::plannerNames().front();
  sylph::PlanningLimits limits;
  std::uint32_t seed = 0;
  std::string weights_path;
  std::string plan_path;
  std::string social_path;
  bool is_json = false;
};

void printJson(const Options& options, const sylph::Evaluation& evaluation,
               const sylph::PlanningStatistics& statistics) {
  nlohmann::ordered_json line;
  line["solved"] = evaluation.is_solved;
  line["planner"] = options.planner;
  line["agents"] = options.instance.agents;
  line["steps"] = evaluation.metrics.steps;
  line["makespan"] = evaluation.metrics.makespan;
  line["sum_of_costs"] = evaluation.metrics.sum_of_costs;
  line["sum_of_costs_lower_bound"] = nullptr;
  if (evaluation.sum_of_costs_lower_bound) {
    line["sum_of_costs_lower_bound"] = *evaluation.sum_of_costs_lower_bound;
  }
  line["proved_sum_of_costs"] = nullptr;
  if (statistics.proved_sum_of_costs) {
    line["proved_sum_of_costs"] = *statistics.proved_sum_of_costs;
  }
  line["arrived"] = evaluation.metrics.arrived;
  line["seconds_to_first"] = nullptr;  // there is no first solution
  if (evaluation.is_solved) {
    line["seconds_to_first"] = statistics.first_solution_s;
  }
  line["seconds"] = statistics.total_s;
  line["policy_calls"] = statistics.policy_calls;
  std::cout << line.dump() << "\n";
}

void printText(const Options& options, const sylph::Evaluation& evaluation,
               const sylph::PlanningResult& result) {
  const sylph::PlanMetrics& metrics = evaluation.metrics;
  std::cout << options.planner << ": " << toString(result.outcome) << ", " << metrics.arrived
            << " of " << options.instance.agents << " agents arrived\n"
            << "steps " << metrics.steps << ", makespan " << metrics.makespan << ", sum of costs "
            << metrics.sum_of_costs << " (lower bound "
            << (evaluation.sum_of_costs_lower_bound
                    ? std::to_string(*evaluation.sum_of_costs_lower_bound)
                    : "unknown");
  if (result.statistics.proved_sum_of_costs) {
    std::cout << ", no plan has less than " << *result.statistics.proved_sum_of_costs;
  }
  std::cout << ")\n";
  if (evaluation.is_solved) {
    std::cout << "first solution after " << result.statistics.first_solution_s << " s, ";
  }
  std::cout << "stopped after " << result.statistics.total_s << " s\n";
}

int plan(const Options& options) {
  const sylph::Deadline deadline(options.limits.time_limit_s);  // of all that follows
  const std::unique_ptr<sylph::Planner> planner = sylph::makePlanner(
      options.planner, sylph::loadPolicy({options.planner}, options.weights_path));
  const sylph::Instance instance = options.instance.load();
  sylph::PlanningLimits limits = options.limits;
  limits.social_states = !options.social_path.empty();
  limits.time_limit_s = deadline.remaining();
  sylph::Rng rng(options.seed);
  const sylph::PlanningResult result = planner->plan(instance, limits, rng);
  const sylph::Evaluation evaluation = sylph::evaluate(instance, result);
  if (evaluation.violation) {
    std::cerr << "sylph_plan: planner '" << options.planner
              << "' broke its promise: " << evaluation.violation->message << "\n";
  }
  if (!options.plan_path.empty() && evaluation.is_solved) {
    sylph::savePlan(result.plan, options.plan_path);
  }
  if (!options.social_path.empty()) {
    sylph::saveSocialStates(result.plan, result.social, options.social_path);
  }
  if (options.is_json) {
    printJson(options, evaluation, result.statistics);
  } else {
    printText(options, evaluation, result);
  }
  return evaluation.is_solved ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Plans a scenario. Exit status: 0 solved, 1 not solved, 2 bad input.", "sylph_plan");
  Options options;
  options.limits.time_limit_s = 10.0;
  sylph::addInstanceOptions(app, options.instance);
  app.add_option("--planner", options.planner, "name of the planner")
      ->check(CLI::IsMember(sylph::plannerNames()))
      ->capture_default_str();
  app.add_option("--time-limit", options.limits.time_limit_s, "[s]")
      ->check(sylph::isPositiveSeconds)
      ->capture_default_str();
  app.add_option("--max-steps", options.limits.max_steps, "longest plan that is of use")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "same seed and one thread, same first plan")
      ->capture_default_str();
  sylph::addWeightsOption(app, options.weights_path);
  app.add_option("--threads", options.limits.threads, "that the planner may use")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()))
      ->capture_default_str();
  app.add_flag("--first", options.limits.first_solution_only, "stop at the first solution");
  app.add_option("--plan", options.plan_path, "file to write the plan to, if solved");
  app.add_option("--social", options.social_path,
                 "CSV file for cell, partner and SVO of each agent at each step, solved or not");
  app.add_flag("--json", options.is_json, "print one line of JSON");
  return sylph::runCommand(app, argc, argv, [&] { return plan(options); });
}
