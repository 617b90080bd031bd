#include "sylph_adg_central/options.hpp"

#include <limits>

#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_ros/parameters.hpp"

namespace sylph_adg_central {
namespace {

void readPositive(const ros::NodeHandle& nh, const std::string& name, double& value) {
  sylph_ros::read(nh, name, value);
  sylph_ros::requirePositive(nh, name, value);
}

}  // namespace

CentralOptions loadCentralOptions(const ros::NodeHandle& private_nh,
                                  const sylph::Experiment& experiment) {
  sylph_ros::requireKnown(private_nh,
                          {"lookahead", "heartbeat_period_s", "resend_after_s", "silent_after_s",
                           "stuck_after_s", "lost_after_s", "start_wait_s"});
  CentralOptions options;
  readPositive(private_nh, "heartbeat_period_s", options.heartbeat_period_s);
  sylph::ExecutionLimits& limits = options.limits;
  sylph_ros::read(private_nh, "lookahead", limits.lookahead);
  sylph_ros::requireInRange(private_nh, "lookahead", limits.lookahead, 1, 100);
  readPositive(private_nh, "resend_after_s", limits.resend_after_s);
  readPositive(private_nh, "silent_after_s", limits.silent_after_s);
  readPositive(private_nh, "stuck_after_s", limits.stuck_after_s);
  readPositive(private_nh, "start_wait_s", limits.start_wait_s);
  sylph_ros::read(private_nh, "lost_after_s", limits.lost_after_s);
  sylph_ros::requireInRange(private_nh, "lost_after_s", limits.lost_after_s, 0.0,
                            std::numeric_limits<double>::max());
  limits.start_offset_m = sylph::largestStartOffset(experiment);
  return options;
}

}  // namespace sylph_adg_central
