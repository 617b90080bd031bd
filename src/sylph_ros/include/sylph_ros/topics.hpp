#pragma once

#include <ros/node_handle.h>

#include <string>

/// Names of topics, services, actions and parameters, each in one place. All are relative.
///
/// A fleet has a namespace: the root unless the user says otherwise (`ROS_NAMESPACE`, `ns:=`). In
/// it the suite's nodes are in `sylph` and each robot's in the robot's name; fleets do not meet.
namespace sylph_ros {

/// Where the suite's nodes are.
constexpr char kSuiteNamespace[] = "sylph";

// In the suite's namespace.
constexpr char kExecuteMissionAction[] = "execute_mission";
constexpr char kJointActionsTopic[] = "joint_actions";
constexpr char kAdgStateTopic[] = "adg_state";
constexpr char kSeparationTopic[] = "separation";
/// std_msgs/Bool, latched: true from the separation monitor stops every robot, past the central
/// node, until the monitor is reset.
constexpr char kEmergencyStopTopic[] = "emergency_stop";
constexpr char kSimulationTruthTopic[] = "simulation_truth";
constexpr char kPauseService[] = "pause";
constexpr char kStopService[] = "stop";
constexpr char kResumeService[] = "resume";
constexpr char kDeclareLostService[] = "declare_lost";
constexpr char kSeparationResetService[] = "separation_monitor/reset";
constexpr char kInjectFaultService[] = "inject_fault";

// Parameters of the suite's namespace, which the launch file sets once and every node reads there.
constexpr char kExperimentParameter[] = "experiment";  // absolute path
constexpr char kSeedParameter[] = "seed";              // -1: the experiment's
constexpr char kPlannerParameter[] = "planner";        // empty: the experiment's
constexpr char kWeightsParameter[] = "weights";        // absolute path, empty: the experiment's
constexpr char kSpeedParameter[] = "speed";            // simulated seconds per second
constexpr char kRunFolderParameter[] = "run_folder";  // absolute path, the central node fills it in

// In a robot's namespace.
constexpr char kTaskTopic[] = "task";
constexpr char kTaskReportTopic[] = "task_report";
constexpr char kPoseTopic[] = "pose";
constexpr char kOdometryTopic[] = "odom";
constexpr char kCommandTopic[] = "cmd_vel";
constexpr char kFootprintTopic[] = "footprint";  // latched PolygonStamped in the robot's frame

// In the fleet's namespace.
constexpr char kMapTopic[] = "map";

constexpr char kMapFrame[] = "map";

/// A name in the fleet's namespace, which is the one around the node's own.
/// @param nh  of a node in the suite's or a robot's namespace
std::string fleetName(const ros::NodeHandle& nh, const std::string& name);

/// A topic of a robot of the same fleet.
std::string robotTopic(const ros::NodeHandle& nh, const std::string& robot,
                       const std::string& topic);

/// A handle in the suite's namespace, for a robot's node.
ros::NodeHandle suiteHandle(const ros::NodeHandle& robot_nh);

}  // namespace sylph_ros
