// What a user of the installed library writes: lets two agents change places and checks the plan.
#include <sylph_core/mapf/check_plan.hpp>
#include <sylph_core/planners/planner.hpp>

int main() {
  const sylph::Grid grid = sylph::Grid::fromText("...\n.#.\n...\n");
  const sylph::Instance instance = {grid, {{0, 0}, {2, 2}}, {{2, 2}, {0, 0}}, {}};
  sylph::PlanningLimits limits;
  limits.first_solution_only = true;
  sylph::Rng rng(1);
  const sylph::Plan plan = sylph::makePlanner("lacam")->plan(instance, limits, rng).plan;
  return plan.back() == instance.goals && !sylph::checkPlan(instance, plan) ? 0 : 1;
}
