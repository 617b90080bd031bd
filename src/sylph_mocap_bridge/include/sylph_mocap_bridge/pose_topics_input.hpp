#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_mocap_bridge/frame_stamper.hpp"
#include "sylph_mocap_bridge/measurement_input.hpp"

namespace sylph_mocap_bridge {

/// Name of the topic: `{rigid_body}` and `{robot}` in the pattern are replaced by the names without
/// the characters that no ROS name may have, as vrpn_client_ros does it: one at the beginning that
/// is no letter, later all but letters, digits, underscores and slashes ("Rigid Body 1" becomes
/// "RigidBody1").
/// @throws std::runtime_error naming the robot if nothing of a name remains
std::string poseTopic(const std::string& pattern, const sylph::RobotSpec& robot);

/// Measurements from the PoseStamped topics of another driver, vrpn_client_ros for one. The
/// protocol behind has no flag for lost bodies: they fall silent.
class PoseTopicsInput : public MeasurementInput {
 public:
  /// @param sink  must outlive the input
  /// @throws std::runtime_error if a name gives no topic or two robots the same
  PoseTopicsInput(ros::NodeHandle& nh, const std::string& pattern, StampPolicy stamp,
                  const std::vector<sylph::RobotSpec>& robots, MeasurementSink& sink);

  Finding look(diagnostic_updater::DiagnosticStatusWrapper& report) override;

 private:
  void onPose(const geometry_msgs::PoseStamped& message, std::size_t robot);

  StampPolicy stamp_;
  MeasurementSink& sink_;
  std::vector<std::string> topics_;          ///< of each robot
  std::vector<std::uint64_t> new_messages_;  ///< of each robot, since the last look
  double last_now_s_ = 0.0;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace sylph_mocap_bridge
