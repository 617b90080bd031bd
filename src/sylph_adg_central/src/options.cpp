#include "sylph_adg_central/options.hpp"

#include "sylph_core/experiment/experiment_margin.hpp"

namespace sylph_adg_central {

CentralOptions readCentralOptions(sylph_ros::ParameterReader& reader) {
  CentralOptions options;
  sylph::ExecutionLimits& limits = options.limits;
  const sylph::Range positive = sylph::Range::positive();
  reader.read("lookahead", limits.lookahead, {1.0, 100.0},
              "released tasks that a robot may have ahead");
  reader.read("heartbeat_period_s", options.heartbeat_period_s, positive,
              "AdgState at least so often");
  reader.read("resend_after_s", limits.resend_after_s, positive,
              "a task that its robot has not confirmed is sent again");
  reader.read("silent_after_s", limits.silent_after_s, positive,
              "a robot without a report for so long is silent");
  reader.read("stuck_after_s", limits.stuck_after_s, positive,
              "a robot that should move and does not for so long is stuck");
  reader.read("lost_after_s", limits.lost_after_s, sylph::Range::atLeast(0.0),
              "a robot in trouble for so long is declared lost; 0: never by itself");
  reader.read("start_wait_s", limits.start_wait_s, positive,
              "a plan waits so long for robots to report and to rest");
  reader.read("align", options.align,
              "before a plan starts, robots that are turned or off the middle of their start cells "
              "turn and drive there one by one");
  sylph_ros::readDiagnosticPeriod(reader);
  return options;
}

CentralOptions loadCentralOptions(const ros::NodeHandle& private_nh,
                                  const sylph::Experiment& experiment) {
  CentralOptions options = sylph_ros::readStrictly(private_nh, readCentralOptions);
  sylph::applyExperiment(experiment, options.align, options.limits);
  return options;
}

}  // namespace sylph_adg_central
