#include "sylph_rehearsal/rehearsal.hpp"

#include "lab.hpp"
#include "sylph_sim/bounds.hpp"

namespace sylph_rehearsal {
namespace {

void requireValid(const LinkOptions& link, const std::string& name) {
  using sylph_sim::requireInRange;
  sylph_sim::requireNotNegative(name + ".delay_s", link.delay_s);
  sylph_sim::requireNotNegative(name + ".jitter_s", link.jitter_s);
  sylph_sim::requireNotNegative(name + ".held_up_s", link.held_up_s);
  requireInRange(name + ".loss", link.loss, 0.0, 1.0);
  requireInRange(name + ".doubling", link.doubling, 0.0, 1.0);
  requireInRange(name + ".reordering", link.reordering, 0.0, 1.0);
}

}  // namespace

std::string toString(Ending ending) {
  switch (ending) {
    case Ending::Finished:
      return "finished";
    case Ending::Stopped:
      return "stopped";
    case Ending::Violated:
      return "violated";
  }
  return "unknown";
}

void requireValid(const RehearsalOptions& options) {
  sylph_sim::requireValid(options.simulation);
  sylph_sim::requirePositive("control_rate_hz", options.control_rate_hz);
  sylph_sim::requirePositive("report_rate_hz", options.report_rate_hz);
  sylph_sim::requirePositive("heartbeat_period_s", options.heartbeat_period_s);
  sylph_sim::requireNotNegative("planning_s", options.planning_s);
  sylph_sim::requirePositive("quiet_s", options.quiet_s);
  sylph_sim::requirePositive("time_limit_s", options.time_limit_s);
  requireValid(options.cameras, "cameras");
  requireValid(options.network, "network");
  requireValid(options.computer, "computer");
}

Rehearsal rehearse(const sylph::Experiment& experiment, const RehearsalOptions& options,
                   const std::shared_ptr<const sylph::Policy>& policy,
                   const std::vector<LabFault>& faults) {
  requireValid(options);
  Lab lab(experiment, options, policy, faults);
  return lab.run();
}

}  // namespace sylph_rehearsal
