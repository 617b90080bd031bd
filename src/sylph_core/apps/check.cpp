// sylph_check: the independent checker of plans as a command.

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <string>

#include "instance_options.hpp"
#include "sylph_core/command/run_command.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "sylph_core/mapf/plan_file.hpp"

namespace {

int check(const sylph::Instance& instance, const sylph::Plan& plan) {
  if (const auto violation = sylph::checkPlan(instance, plan)) {
    std::cout << "refused: " << violation->message << "\n";
    return EXIT_FAILURE;
  }
  const sylph::PlanMetrics metrics = sylph::computeMetrics(instance, plan);
  std::cout << "valid: " << instance.agentCount() << " agents, " << metrics.steps
            << " steps, makespan " << metrics.makespan << ", sum of costs " << metrics.sum_of_costs
            << "\n";
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Checks that a plan solves a scenario. Exit status: 0 it does, 1 it does not, 2 bad input.",
      "sylph_check");
  sylph::InstanceOptions instance;
  std::string plan_path;
  sylph::addInstanceOptions(app, instance);
  app.add_option("PLAN", plan_path, "one configuration a line: 'step: (row,col) (row,col) ...'")
      ->required();
  return sylph::runCommand(app, argc, argv,
                           [&] { return check(instance.load(), sylph::loadPlan(plan_path)); });
}
