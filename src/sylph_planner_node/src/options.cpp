#include "sylph_planner_node/options.hpp"

namespace sylph_planner_node {

Options readOptions(sylph_ros::ParameterReader& reader) {
  Options options;
  const auto read = [&](const char* name, double& value, const char* meaning) {
    reader.read(name, value, sylph::Range::positive(), meaning);
  };
  read("tick_period_s", options.tick_period_s, "period of the mission's state machine");
  read("feedback_period_s", options.feedback_period_s, "period of the action's feedback");
  read("map_period_s", options.map_period_s, "between two repetitions of the map");
  read("resend_period_s", options.limits.resend_period_s,
       "before a plan that did not arrive is sent again");
  read("pose_timeout_s", options.pose_timeout_s, "a pose that came earlier is stale");
  read("pose_wait_s", options.limits.pose_wait_s,
       "wall time that a starting mission waits for good poses");
  read("central_wait_s", options.limits.central_wait_s,
       "wall time that it waits for the central node");
  read("hold_wait_s", options.limits.hold_wait_s,
       "how long a cancelled mission waits for the robots to hold");
  read("replanning_time_limit_s", options.limits.replanning_time_limit_s,
       "wall time for planning around lost robots");
  reader.read("search_steps_per_s", options.search_steps_per_s, sylph::Range::atLeast(0.0),
              "so many steps of the search are a planner's second, so that a plan depends on its "
              "seed and not on the machine; 0: wall time");
  reader.read("ignore_unseen_robots", options.limits.ignores_unseen_robots,
              "plan although a robot without part in the mission is not seen within `pose_wait_s`");
  sylph_ros::readDiagnosticPeriod(reader);
  return options;
}

}  // namespace sylph_planner_node
