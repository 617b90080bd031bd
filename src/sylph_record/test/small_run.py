"""A run of two robots, made by hand: both drive three cells east, robot_1 waits for robot_0."""
import json
import math
import os

import rosbag
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import OccupancyGrid
from sylph_msgs.msg import (
    AdgState,
    AgentAction,
    Cell,
    JointAction,
    JointActions,
    RobotExecution,
    SeparationState,
    Task,
    TaskReport,
)

ROBOTS = ["robot_0", "robot_1"]
START_S = 100.0
SECONDS = 4


def adg_state(time_s):
    """Robot 0 is done after 3 s, robot 1 waits for it in the second second."""
    state = AdgState(plan_id=1, phase=AdgState.EXECUTING, steps=3)
    state.header.frame_id = "map"
    for index, name in enumerate(ROBOTS):
        robot = RobotExecution(robot_id=name, tasks_total=3, svo_deg=15.0 * index)
        robot.tasks_done = min(3, int(time_s))
        robot.cell = Cell(index, robot.tasks_done)
        robot.goal = Cell(index, 3)
        robot.partner = ROBOTS[1 - index]
        state.robots.append(robot)
    state.robots[0].svo_deg = math.nan
    if 1.0 <= time_s < 2.0:
        state.robots[1].waiting = True
        state.robots[1].waits_for_robot = ROBOTS[0]
        state.robots[1].root_cause_robot = ROBOTS[0]
        state.robots[1].root_cause = f"silent for {time_s:.1f} s"
    return state


def joint_actions():
    step = JointAction(actions=[AgentAction(action=AgentAction.EAST) for _ in ROBOTS])
    return JointActions(plan_id=1, agents=ROBOTS, steps=[step] * 3)


def pose(index, time_s, corner_m=(0.0, 0.0)):
    message = PoseStamped()
    message.header.frame_id = "map"
    message.pose.position.x = corner_m[0] + 0.15 + 0.3 * min(3.0, time_s)
    message.pose.position.y = corner_m[1] + 0.45 - 0.3 * index
    message.pose.orientation.w = 1.0
    return message


def write_bag(path, leave_out=(), compression="none", corner_m=(0.0, 0.0)):
    """Writes the run's bag. Topics in `leave_out` are missing; the map's lower left corner is at `corner_m`."""
    with rosbag.Bag(path, "w", compression, chunk_threshold=4096) as bag:

        def write(topic, message, time_s, is_latched=False):
            if topic not in leave_out:
                header = {"topic": topic, "type": message._type, "md5sum": message._md5sum,
                          "message_definition": message._full_text, "latching": "1"}  # fmt: skip
                bag.write(topic, message, rospy.Time.from_sec(START_S + time_s),
                          connection_header=header if is_latched else None)  # fmt: skip

        grid = OccupancyGrid(data=[0] * 8)
        grid.info.width, grid.info.height, grid.info.resolution = 4, 2, 0.3
        grid.info.origin.position.x, grid.info.origin.position.y = corner_m
        write("/map", grid, 0.0, is_latched=True)
        write("/sylph/joint_actions", joint_actions(), 0.0)
        write("/sylph/joint_actions", JointActions(), SECONDS)
        for tick in range(10 * SECONDS):
            time_s = 0.1 * tick
            write("/diagnostics", DiagnosticArray(), time_s)
            write("/sylph/adg_state", adg_state(time_s), time_s)
            gap = SeparationState(separation_m=0.1 + 0.01 * (tick % 5), limit_m=0.03)
            write("/sylph/separation", gap, time_s)
            for index, name in enumerate(ROBOTS):
                at = pose(index, time_s, corner_m)
                write(f"/{name}/pose", at, time_s)
                place = at.pose.position
                report = TaskReport(robot_id=name, x=place.x, y=place.y, tracking_error_m=0.002 * (index + 1))
                write(f"/{name}/task_report", report, time_s)
                write(f"/{name}/task", Task(robot_id=name), time_s)
                write(f"/{name}/cmd_vel", Twist(), time_s)


def events():
    """What the central node would have logged."""
    yield {"stamp": START_S, "event": "plan", "plan_id": 1, "plan": {"robots": ROBOTS}}
    for second in range(3):
        for name in ROBOTS:
            task = {"plan_id": 1, "robot": name, "sequence": second}
            yield {"stamp": START_S + second, "event": "released", **task}
            yield {"stamp": START_S + second + 1.0, "event": "done", **task}
    yield {"stamp": START_S + 3.0, "event": "mode", "plan_id": 1, "mode": "stop", "reason": "by the user"}


def write_folder(folder):
    """A whole run folder."""
    write_bag(os.path.join(folder, "run.bag"))
    files = {
        "result.yaml": "success: true\nrobots: 2\nmin_separation_m: 0.1\n",
        "events.jsonl": "".join(json.dumps(event) + "\n" for event in events()),
        "experiment.yaml": "cell_size_m: 0.3\nexecution: {speed_limit_mps: 0.3}\n",
    }
    for name, content in files.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(content)


class OldTask(Task):
    """A message as an earlier version of the suite defined it."""

    _md5sum = "0" * 32
    _full_text = Task._full_text.replace("uint32 robot_tasks", "uint16 tasks").replace("int32 row", "int8 row")


def write_old_bag(path):
    """A bag of an earlier version of the suite."""
    with rosbag.Bag(path, "w") as bag:
        bag.write("/sylph/adg_state", adg_state(0.0), rospy.Time.from_sec(START_S))
        bag.write("/robot_0/task", OldTask(), rospy.Time.from_sec(START_S))
