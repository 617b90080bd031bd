#include "sylph_rehearsal/rehearsal.hpp"

#include "lab.hpp"
#include "sylph_sim/bounds.hpp"

namespace sylph_rehearsal {
namespace {

using sylph_sim::requireWithin;

void requireValid(const LinkOptions& link, const std::string& name) {
  const sylph::Range share{0.0, 1.0};
  const sylph::Range duration = sylph::Range::atLeast(0.0);
  requireWithin(name + ".delay_s", link.delay_s, duration);
  requireWithin(name + ".jitter_s", link.jitter_s, duration);
  requireWithin(name + ".held_up_s", link.held_up_s, duration);
  requireWithin(name + ".loss", link.loss, share);
  requireWithin(name + ".doubling", link.doubling, share);
  requireWithin(name + ".reordering", link.reordering, share);
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
  const sylph::Range positive = sylph::Range::positive();
  requireWithin("control_rate_hz", options.control_rate_hz, positive);
  requireWithin("report_rate_hz", options.report_rate_hz, positive);
  requireWithin("heartbeat_period_s", options.heartbeat_period_s, positive);
  requireWithin("planning_s", options.planning_s, sylph::Range::atLeast(0.0));
  requireWithin("quiet_s", options.quiet_s, positive);
  requireWithin("time_limit_s", options.time_limit_s, positive);
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
