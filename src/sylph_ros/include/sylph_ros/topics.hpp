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
/// sylph_msgs/ExecuteMission: an operator's mission, to the planner.
constexpr char kExecuteMissionAction[] = "execute_mission";
/// sylph_msgs/ExecuteMission: as above, but the plan is made, checked and shown, and nothing moves.
constexpr char kPlanMissionAction[] = "plan_mission";
/// sylph_msgs/JointActions, latched: the plan that was made to be looked at; `plan_id` is its
/// number among those, 0: none. No robot is moved by it.
constexpr char kShownPlanTopic[] = "shown_plan";
/// sylph_msgs/JointActions, latched: a plan, from the planner to the central node.
constexpr char kJointActionsTopic[] = "joint_actions";
/// sylph_msgs/AdgState: from the central node to everybody.
constexpr char kAdgStateTopic[] = "adg_state";
/// sylph_msgs/SeparationState: the closest pair, from the separation monitor.
constexpr char kSeparationTopic[] = "separation";
/// std_msgs/Bool, latched: true from the separation monitor stops every robot, past the central
/// node, until the monitor is reset.
constexpr char kEmergencyStopTopic[] = "emergency_stop";
/// std_msgs/String, to newcomers again: the robot that the operator looks at; empty: none.
constexpr char kSelectedRobotTopic[] = "selected_robot";
/// geometry_msgs/PoseStamped in the map frame, of RViz's "2D Nav Goal": a goal for that robot.
constexpr char kNavGoalTopic[] = "nav_goal";
/// Namespace of the interactive markers by which robots are selected and their goals are dragged.
constexpr char kGoalMarkersTopic[] = "goal_markers";
/// sylph_msgs/ReplayExtent, latched: which part of time a replay's bag covers.
constexpr char kReplayExtentTopic[] = "replay_extent";
/// std_msgs/Float64: to where in the bag a replay is to go, from its beginning [s].
constexpr char kReplaySeekTopic[] = "replay_seek";
/// sylph_msgs/SimulationTruth: where the simulator's robots really are.
constexpr char kSimulationTruthTopic[] = "simulation_truth";
/// std_srvs/Trigger of the central node: robots finish the tasks that they have.
constexpr char kPauseService[] = "pause";
/// std_srvs/Trigger of the central node: robots ramp to zero at once.
constexpr char kStopService[] = "stop";
/// std_srvs/Trigger of the central node: robots go on.
constexpr char kResumeService[] = "resume";
/// sylph_msgs/DeclareLost of the central node: a robot is out of the mission.
constexpr char kDeclareLostService[] = "declare_lost";
/// std_srvs/Trigger of the separation monitor: ends its emergency stop.
constexpr char kSeparationResetService[] = "separation_monitor/reset";
/// sylph_msgs/InjectFault of the simulator.
constexpr char kInjectFaultService[] = "inject_fault";

// Of the simulator and the nodes in lock step with it, see LockStepTick.msg.
/// sylph_msgs/LockStepTick: nodes act whose messages are handled in the same tick, as the bridge.
constexpr char kLockStepFirstTopic[] = "lock_step/first";
/// sylph_msgs/LockStepTick: all other nodes act.
constexpr char kLockStepSecondTopic[] = "lock_step/second";
/// sylph_msgs/LockStepDone: a node has acted.
constexpr char kLockStepDoneTopic[] = "lock_step/done";

// Parameters of the suite's namespace, which the launch file sets once and every node reads there.
/// Absolute path of the experiment file.
constexpr char kExperimentParameter[] = "experiment";
/// Of what the experiment calls random; -1: the experiment's.
constexpr char kSeedParameter[] = "seed";
/// Name of the planner; empty: the experiment's.
constexpr char kPlannerParameter[] = "planner";
/// Absolute path of the policy's weights; empty: the experiment's.
constexpr char kWeightsParameter[] = "weights";
/// Simulated seconds per second; 0: as many as the machine can.
constexpr char kSpeedParameter[] = "speed";
/// Whether the simulator waits for the nodes.
constexpr char kLockStepParameter[] = "lock_step";
/// Absolute path of the run's folder; the central node fills it in where it is empty.
constexpr char kRunFolderParameter[] = "run_folder";

// In a robot's namespace.
/// sylph_msgs/Task: from the central node to the robot.
constexpr char kTaskTopic[] = "task";
/// sylph_msgs/TaskReport: from the robot to the central node.
constexpr char kTaskReportTopic[] = "task_report";
/// geometry_msgs/PoseStamped in the map frame: from motion capture.
constexpr char kPoseTopic[] = "pose";
/// nav_msgs/Odometry: pose with velocity, from motion capture.
constexpr char kOdometryTopic[] = "odom";
/// geometry_msgs/Twist in the robot's frame: to its base.
constexpr char kCommandTopic[] = "cmd_vel";
/// std_srvs/Trigger of the robot's node: the operator has looked, its pose is right.
constexpr char kConfirmPoseService[] = "confirm_pose";
/// geometry_msgs/PolygonStamped in the robot's frame, latched.
constexpr char kFootprintTopic[] = "footprint";

// In the fleet's namespace.
/// nav_msgs/OccupancyGrid, latched, of the present mission.
constexpr char kMapTopic[] = "map";

/// Frame of everything that is not said in a robot's own (REP 105).
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
