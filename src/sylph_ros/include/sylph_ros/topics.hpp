#pragma once

/// Names of topics, services and actions, each in one place. They are relative: the launch file's
/// namespace makes
/// `/sylph/joint_actions` and `/robot_3/task` of them, and <remap> works.
namespace sylph_ros {

// In the namespace of the suite, `sylph`.
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

// In the namespace of one robot, `robot_<i>`.
constexpr char kTaskTopic[] = "task";
constexpr char kTaskReportTopic[] = "task_report";
constexpr char kPoseTopic[] = "pose";
constexpr char kOdometryTopic[] = "odom";
constexpr char kCommandTopic[] = "cmd_vel";
constexpr char kFootprintTopic[] = "footprint";  // latched PolygonStamped in the robot's frame

// Global.
constexpr char kMapTopic[] = "/map";

constexpr char kMapFrame[] = "map";

/// Namespace of the suite, absolute: for nodes that run in a robot's namespace.
constexpr char kSuiteNamespace[] = "/sylph";

/// Simulated seconds per second, a parameter that the launch file sets; absent on real robots.
constexpr char kSpeedParameter[] = "/sylph/speed";

/// Folder of the present run, set by the central node.
constexpr char kRunFolderParameter[] = "/sylph/run_folder";

}  // namespace sylph_ros
