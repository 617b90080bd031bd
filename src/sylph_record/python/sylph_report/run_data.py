"""Reads a run folder into plain lists, ready for figures. Times are seconds since the first task."""
import json
import math
import os
import re
import struct
from dataclasses import dataclass, field

import rosbag
import roslib.message
import yaml

from sylph_report.bag_reader import BagReader
from sylph_report.recorded import changed_type, recorded_fleet

# Defaults of an experiment's `execution` section.
SPEED_LIMIT_MPS = 0.25
TRACKING_ERROR_M = 0.012
CELL_SIZE_M = 0.3
FOOTPRINT_M = (0.23, 0.20)

# Topics, below the fleet's namespace.
ADG_STATE = "sylph/adg_state"
JOINT_ACTIONS = "sylph/joint_actions"
SEPARATION = "sylph/separation"
TRUTH = "sylph/simulation_truth"
MAP = "map"
TASK_REPORT_TYPE = "sylph_msgs/TaskReport"

# Numbers at the end of a TaskReport: x, y, yaw, tracking error, heading error, age of the pose. There are so many reports
# that to build an object of each takes longer than all the rest.
REPORT_END = struct.Struct("<6d")
# An AdgState tells of all robots and takes a millisecond to read, so that so many robots' states are enough.
MOST_ROBOT_STATES = 12000

EXECUTING = 2
FINISHED = 5
CONDITIONS = {1: "silent", 2: "stuck", 3: "blind", 4: "lost"}
MODES = {1: "paused", 2: "stopped"}


@dataclass
class RobotRun:
    """One robot's run. The lists of one kind of sample have the same length."""

    start_cell: tuple = ()  # row, column
    goal_cell: tuple = ()
    time_s: list = field(default_factory=list)
    cells_done: list = field(default_factory=list)  # moves measured as DONE since the run began
    waiting: list = field(default_factory=list)
    cause: list = field(default_factory=list)  # (root cause robot, reason) or None
    partner: list = field(default_factory=list)  # name or ""
    svo_deg: list = field(default_factory=list)  # NaN: none
    planned_time_s: list = field(default_factory=list)
    planned_cells: list = field(default_factory=list)
    error_time_s: list = field(default_factory=list)
    tracking_error_m: list = field(default_factory=list)
    pose: list = field(default_factory=list)  # at error_time_s: (x [m], y [m], yaw [rad]), NaN before the first one


@dataclass
class Run:
    """A run folder's content. What was missing is said in `missing`, one line each."""

    name: str
    robots: dict = field(default_factory=dict)  # name -> RobotRun, in the mission's order
    separation: list = field(default_factory=list)  # (time_s, gap_m)
    separation_limit_m: float = 0.0
    obstacles: list = field(default_factory=list)  # rows of cells from the bag's map, the first is the northern one
    corner_m: tuple = (0.0, 0.0)  # x, y of the map's lower left corner in frame `map`
    footprint_m: tuple = FOOTPRINT_M
    truth: dict = field(default_factory=dict)  # ground truth of a simulation
    result: dict = field(default_factory=dict)
    events: list = field(default_factory=list)
    cell_size_m: float = CELL_SIZE_M
    speed_limit_mps: float = SPEED_LIMIT_MPS
    tracking_limit_m: float = TRACKING_ERROR_M
    missing: list = field(default_factory=list)


def load(folder):
    """Everything that the folder has."""
    run = Run(os.path.basename(os.path.abspath(folder)))
    _load_experiment(run, os.path.join(folder, "experiment.yaml"))
    run.result = _load_yaml(run, os.path.join(folder, "result.yaml"))
    _load_events(run, os.path.join(folder, "events.jsonl"))
    _load_bag(run, os.path.join(folder, "run.bag"))
    if not run.robots:
        _progress_from_events(run)
    return run


def waiting_by_cause(robot):
    """Seconds that a robot waited, by (root cause robot, reason)."""
    seconds = {}
    for i in range(1, len(robot.time_s)):
        if robot.waiting[i - 1]:
            cause = robot.cause[i - 1] or ("", "unknown")
            seconds[cause] = seconds.get(cause, 0.0) + robot.time_s[i] - robot.time_s[i - 1]
    return seconds


def _load_yaml(run, path):
    try:
        with open(path, encoding="utf-8") as file:
            content = yaml.safe_load(file)
    except OSError as error:
        run.missing.append(f"{path}: {error.strerror}")
        return {}
    except yaml.YAMLError as error:
        run.missing.append(f"{path}: not YAML: {' '.join(str(error).split())}")
        return {}
    if not isinstance(content, dict):
        run.missing.append(f"{path}: must be a map of names to values")
        return {}
    return content


def _load_experiment(run, path):
    content = _load_yaml(run, path)
    try:
        execution = dict(content.get("execution") or {})
        run.cell_size_m = float(content.get("cell_size_m", run.cell_size_m))
        length, width = content.get("footprint_m", run.footprint_m)
        run.footprint_m = (float(length), float(width))
        run.speed_limit_mps = float(execution.get("speed_limit_mps", run.speed_limit_mps))
        run.tracking_limit_m = float(execution.get("tracking_error_m", run.tracking_limit_m))
    except (TypeError, ValueError) as error:
        run.missing.append(f"{path}: not an experiment: {error}")


def _load_events(run, path):
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except OSError as error:
        run.missing.append(f"{path}: {error.strerror}")
        return
    for number, line in enumerate(lines, 1):
        try:
            event = json.loads(line)
            run.events.append({**event, "stamp": float(event["stamp"]), "event": event["event"]})
        except (KeyError, TypeError, ValueError) as error:
            run.missing.append(f"{path}:{number}: not an event: {type(error).__name__}: {error}")
            return


def _progress_from_events(run):
    """Who was where when, from the event log alone."""
    stamps = [event["stamp"] for event in run.events if event["event"] == "released"]
    if not stamps:
        return
    start_s = min(stamps)
    for event in run.events:
        time_s = event["stamp"] - start_s
        if event["event"] == "plan":
            for name in event.get("plan", {}).get("robots", []):
                _add_sample(run.robots.setdefault(name, RobotRun()), max(0.0, time_s), 0)
        elif event["event"] == "done" and "robot" in event:
            _add_sample(run.robots.setdefault(event["robot"], RobotRun()), time_s, 1)


def _add_sample(robot, time_s, cells):
    robot.time_s.append(time_s)
    robot.cells_done.append((robot.cells_done[-1] if robot.cells_done else 0) + cells)
    robot.waiting.append(False)
    robot.cause.append(None)
    robot.partner.append("")
    robot.svo_deg.append(math.nan)


def _load_bag(run, path):
    if not os.path.isfile(path):
        hint = " (run.bag.active is there: the recorder did not end; rosbag reindex mends it)"
        was_cut = os.path.isfile(path + ".active")
        run.missing.append(
            f"{path}: missing, so only the event log is drawn{hint if was_cut else ''}"
        )
        return
    try:
        bag = BagReader(path)
        changed = changed_type(bag.connections.values())
        if changed:
            run.missing.append(f"{path}: {changed}")
        else:
            _read_bag(run, bag)
    except (rosbag.ROSBagException, OSError) as error:
        run.missing.append(f"{path}: not a readable bag: {error}")


def _read_bag(run, bag):
    types = bag.topics()
    fleet = recorded_fleet(types) or "/"
    reports = [topic for topic, type_name in types.items() if type_name == TASK_REPORT_TYPE]
    wanted = [fleet + topic for topic in (ADG_STATE, JOINT_ACTIONS, SEPARATION, TRUTH, MAP)] + reports
    for topic in (ADG_STATE, JOINT_ACTIONS, SEPARATION):
        if fleet + topic not in types:
            run.missing.append(f"run.bag: has no {fleet}{topic}")
    classes = {topic: roslib.message.get_message_class(types[topic]) for topic in wanted if topic in types}
    messages = bag.read(wanted)
    last = {topic: index for index, (_, topic, _) in enumerate(messages)}
    states = sum(topic == fleet + ADG_STATE for _, topic, _ in messages)
    every = max(1, math.ceil(states * len(reports) / MOST_ROBOT_STATES))
    reader = _RunReader(run)
    states = 0
    for index, (time_s, topic, data) in enumerate(messages):
        if topic in reports:
            reader.take_report(topic[len(fleet):].split("/")[0], REPORT_END.unpack(data[-REPORT_END.size:]), time_s)
            continue
        if topic == fleet + ADG_STATE:
            states += 1
            if reader.is_running() and states % every and index != last[topic]:
                continue
        if topic in (fleet + TRUTH, fleet + MAP) and index != last[topic]:  # one counts up, the other stays
            continue
        reader.take(topic[len(fleet):], classes[topic]().deserialize(data), time_s)
    reader.finish()


class _RunReader:
    """Sorts a bag's messages into a Run."""

    def __init__(self, run):
        self._run = run
        self._start_s = None  # ROS time of the first task
        self._steps = {}  # plan_id -> [{robot: action}], one per timestep
        self._plan_start = {}  # plan_id -> (time_s, {robot: cells done before})
        self._plan_id = 0
        self._is_over = False

    def take(self, topic, message, received_s):
        if topic == ADG_STATE:
            self._take_state(message, received_s)
        elif topic == JOINT_ACTIONS:
            self._steps[message.plan_id] = [
                dict(zip(message.agents, (a.action for a in step.actions))) for step in message.steps
            ]
        elif topic == SEPARATION:
            self._take_separation(message, received_s)
        elif topic == MAP:
            width = message.info.width
            rows = [message.data[row * width : (row + 1) * width] for row in range(message.info.height)]
            self._run.obstacles = [[cell != 0 for cell in row] for row in reversed(rows)]
            self._run.cell_size_m = round(message.info.resolution, 6)  # a float32
            corner = message.info.origin.position
            self._run.corner_m = (corner.x, corner.y)
        elif topic == TRUTH:
            self._run.truth = {
                "true smallest gap [m]": message.min_separation_m,
                "true collisions": message.collisions,
            }

    def take_report(self, name, numbers, received_s):
        """Takes the numbers at the end of a robot's TaskReport."""
        if self.is_running():
            robot = self._run.robots.setdefault(name, RobotRun())
            robot.error_time_s.append(received_s - self._start_s)
            robot.tracking_error_m.append(numbers[3])
            robot.pose.append(numbers[:3])

    def finish(self):
        """Adds the plans, whose steps are spread over their shortest possible time."""
        step_s = self._run.cell_size_m / self._run.speed_limit_mps
        for plan_id, (start_s, done) in self._plan_start.items():
            cells = dict(done)
            steps = self._steps.get(plan_id, [])
            # The last sample is where everybody rests.
            for step, actions in enumerate(steps + [dict.fromkeys(steps[-1], 0)] if steps else []):
                for name, action in actions.items():
                    robot = self._run.robots.setdefault(name, RobotRun())
                    robot.planned_time_s.append(start_s + step * step_s)
                    robot.planned_cells.append(cells.get(name, 0))
                    cells[name] = cells.get(name, 0) + (action != 0)

    def is_running(self):
        """Whether a task has been released and not all are done."""
        return self._start_s is not None and not self._is_over

    def _take_separation(self, message, received_s):
        self._run.separation_limit_m = message.limit_m
        if self.is_running() and math.isfinite(message.separation_m):
            self._run.separation.append((received_s - self._start_s, message.separation_m))

    def _take_state(self, message, received_s):
        if self._start_s is None:
            if message.phase < EXECUTING or not message.plan_id:
                return
            self._start_s = received_s
        if self._is_over and message.phase == FINISHED:
            return
        self._is_over = message.phase == FINISHED
        time_s = received_s - self._start_s
        if message.plan_id != self._plan_id and message.phase == EXECUTING:
            done = {
                name: robot.cells_done[-1]
                for name, robot in self._run.robots.items()
                if robot.cells_done
            }
            self._plan_start[message.plan_id] = (time_s, done)
            self._plan_id = message.plan_id
        for state in message.robots:
            self._take_robot(state, message.mode, time_s)

    def _take_robot(self, state, mode, time_s):
        robot = self._run.robots.setdefault(state.robot_id, RobotRun())
        before = self._plan_start.get(self._plan_id, (0.0, {}))[1].get(state.robot_id, 0)
        held = mode in MODES and state.tasks_done < state.tasks_total
        robot.start_cell = robot.start_cell or (state.cell.row, state.cell.col)
        robot.goal_cell = (state.goal.row, state.goal.col)
        robot.time_s.append(time_s)
        robot.cells_done.append(before + state.tasks_done)
        robot.waiting.append(bool(state.waiting) or held)
        robot.cause.append(_cause_of(state, mode if held else 0))
        robot.partner.append(state.partner)
        robot.svo_deg.append(state.svo_deg)


def _cause_of(state, mode):
    if mode in MODES:
        return ("", MODES[mode])
    if not state.waiting:
        return None
    reason = cause_kind(state.root_cause) or CONDITIONS.get(state.condition, "moves")
    return (state.root_cause_robot or state.waits_for_robot, reason)


def cause_kind(text):
    """What "no good pose: pose is 0.3 s old by its stamp" and "no good pose: no pose yet" have in common."""
    kind = re.sub(r" (for|from|after) [^ ]*\d.*$| yet$", "", text.split(":")[0].strip())
    return {"pause": MODES[1], "stop": MODES[2]}.get(kind, kind)
