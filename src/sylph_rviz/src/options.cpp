#include "sylph_rviz/options.hpp"

namespace sylph_rviz {

Options readOptions(sylph_ros::ParameterReader& reader) {
  Options options;
  const sylph::Range positive = sylph::Range::positive();
  reader.read("rate_hz", options.rate_hz, {1.0, 60.0},
              "how often a layer that is looked at is sent");
  reader.read("lifetime_s", options.lifetime_s, positive,
              "after this long without a message markers vanish; longer than 1 / `rate_hz`");
  reader.read("pose_timeout_s", options.pose_timeout_s, positive,
              "a robot whose pose is so much older than the newest input is drawn faint");
  if (options.lifetime_s < 1.0 / options.rate_hz) {
    throw reader.error("lifetime_s", "must be at least 1 / rate_hz = " +
                                         sylph::shortNumber(1.0 / options.rate_hz));
  }
  return options;
}

}  // namespace sylph_rviz
