#include "sylph_core/experiment/experiment_control.hpp"

namespace sylph {

void applyExecution(const ExecutionSpec& execution, RobotControllerOptions& controller) {
  controller.base.timeout_s = execution.base_timeout_s;
  controller.cell_margin_m = execution.tracking_error_m;
  controller.limits.speed_mps = execution.speed_limit_mps;
  controller.limits.turn_rate_radps = execution.turn_rate_limit_radps;
  controller.follower.speed_limit_mps = execution.speed_limit_mps;
  controller.follower.acceleration_limit_mps2 = execution.acceleration_limit_mps2;
  controller.follower.heading_tolerance_rad = execution.heading_tolerance_rad;
  controller.follower.tracking_error_m = execution.tracking_error_m;
  controller.follower.heading.output_limit = execution.turn_rate_limit_radps;
  controller.arrival.position_tolerance_m = execution.position_tolerance_m;
  controller.arrival.heading_tolerance_rad = execution.heading_tolerance_rad;
  controller.arrival.tracking_error_m = execution.tracking_error_m;
  controller.arrival.acceleration_limit_mps2 = execution.acceleration_limit_mps2;
  controller.watch.timeout_s = execution.pose_timeout_s;
  controller.watch.speed_limit_mps = execution.speed_limit_mps;
  controller.watch.turn_rate_limit_radps = execution.turn_rate_limit_radps;
}

RobotControllerOptions controllerOptionsFor(const ExecutionSpec& execution) {
  RobotControllerOptions controller;
  applyExecution(execution, controller);
  return controller;
}

}  // namespace sylph
