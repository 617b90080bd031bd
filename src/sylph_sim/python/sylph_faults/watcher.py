"""Follows one run of the lab experiment as a ROS node."""
import math
import os
import re
import signal
import time
import xmlrpc.client

import rospy
from sylph_msgs.msg import AdgState, SimulationTruth
from sylph_msgs.srv import InjectFault

MOVED_M = 0.02  # a robot that is this far from its start has moved
QUIET_S = 25.0  # simulated time without a new DONE after which nobody is expected to arrive any more
POLL_S = 0.005  # of the wall


class Watcher:
    """Makes a case's faults happen, counted from the first motion, and tells how the run went.

    Times are simulated seconds unless they say otherwise. Needs rospy.init_node(), in the fleet's namespace.
    """

    def __init__(self, case):
        self._faults = sorted(case.get("faults", []), key=lambda fault: fault["at_s"])
        self._signals = signals_of(case)
        self._paused = {}
        self._starts = None
        self._began_s = None
        self._truth = None
        self._done = 0
        self._total = 0
        self._is_finished = False
        self._tasks_left = {}
        self._roles = {}
        self._progress_s = 0.0
        self._inject = rospy.ServiceProxy("sylph/inject_fault", InjectFault)
        rospy.Subscriber("sylph/simulation_truth", SimulationTruth, self._on_truth, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber("sylph/adg_state", AdgState, self._on_state, queue_size=1, tcp_nodelay=True)

    def watch(self, wall_limit_s):
        """Until the robots have arrived, nothing moves on any more, or the wall limit.

        Returns a dictionary with `outcome` (arrived, held, or why the run says nothing) and the truth's figures.
        """
        outcome = "it took too long"
        deadline = time.monotonic() + wall_limit_s
        while time.monotonic() < deadline and not rospy.is_shutdown():
            time.sleep(POLL_S)
            if self._began_s is None:
                continue
            self._act()
            if self._is_finished:
                outcome = "the run was over before the fault" if self._faults or self._signals else "arrived"
                break
            if self._truth.header.stamp.to_sec() - self._progress_s > QUIET_S:
                outcome = "held"
                break
        return self._report(outcome)

    def _on_truth(self, truth):
        if self._starts is None:
            self._starts = truth.poses
        has_moved = any(math.hypot(a.x - b.x, a.y - b.y) > MOVED_M for a, b in zip(truth.poses, self._starts))
        self._truth = truth
        if self._began_s is None and has_moved:
            self._began_s = self._progress_s = truth.header.stamp.to_sec()

    def _on_state(self, state):
        done = sum(robot.tasks_done for robot in state.robots)
        if done != self._done and self._truth is not None:
            self._progress_s = self._truth.header.stamp.to_sec()
        self._done = done
        self._total = sum(robot.tasks_total for robot in state.robots)
        self._tasks_left = {robot.robot_id: robot.tasks_total - robot.tasks_done for robot in state.robots}
        self._is_finished = state.phase == AdgState.FINISHED

    def _elapsed_s(self):
        return 0.0 if self._began_s is None else self._truth.header.stamp.to_sec() - self._began_s

    def _act(self):
        while self._faults and self._elapsed_s() >= self._faults[0]["at_s"]:
            fault = self._faults.pop(0)
            robots = [self._cast(robot) for robot in fault.get("robots", [])]
            answer = self._inject(fault["kind"], robots, 0.0, fault.get("duration_s", 0.0), fault.get("value", 0.0))
            if not answer.success:
                raise ValueError(answer.message)
        while self._signals and self._elapsed_s() >= self._signals[0][0]:
            _, node, number = self._signals.pop(0)
            self._send(node, number)

    def _send(self, node, number):
        # A node that is paused does not tell its process.
        processes = self._paused.pop(node) if number == signal.SIGCONT else processes_of(self._cast(node))
        for process in processes:
            os.kill(process, number)
        if number == signal.SIGSTOP:
            self._paused[node] = processes

    def _cast(self, text):
        """The text with roles in braces replaced by names of robots; they stay the same for the whole run.

        {busy} is the robot with the most tasks left when the first fault is due, {near} the one closest to it.
        """
        if not self._roles:
            names = list(self._truth.robots)
            place = dict(zip(names, self._truth.poses))
            busy = max(names, key=lambda name: self._tasks_left.get(name, 0))
            near = min((name for name in names if name != busy), default=busy,
                       key=lambda name: math.hypot(place[name].x - place[busy].x, place[name].y - place[busy].y))
            self._roles = {"busy": busy, "near": near}
        return text.format(**self._roles)

    def _report(self, outcome):
        if self._began_s is None:
            return {"outcome": "no truth came" if self._truth is None else "no robot moved"}
        return {
            "outcome": outcome,
            "collisions": self._truth.collisions,
            "obstacle_entries": self._truth.obstacle_entries,
            "min_separation_mm": round(1000.0 * self._truth.min_separation_m, 1),
            "seconds": round(self._elapsed_s(), 1),
            "tasks": f"{self._done}/{self._total}",
        }


def signals_of(case):
    """The signals that a case sends: (time, pattern of the nodes' names, number), by time.

    A kill is a SIGKILL; a pause is a SIGSTOP and then a SIGCONT, as if a node got no processor time.
    """
    signals = [(kill["at_s"], kill["node"], signal.SIGKILL) for kill in case.get("kills", [])]
    for pause in case.get("pauses", []):
        signals.append((pause["at_s"], pause["node"], signal.SIGSTOP))
        signals.append((pause["at_s"] + pause["duration_s"], pause["node"], signal.SIGCONT))
    return sorted(signals)


def processes_of(pattern):
    """The processes of all nodes of this machine whose name below the fleet's namespace the pattern matches.

    Raises ValueError if there is none.
    """
    master = rospy.get_master()
    _, _, system = master.getSystemState()
    names = {node for topics in system for _, nodes in topics for node in nodes if re.fullmatch(re.escape(rospy.get_namespace()) + pattern, node)}
    if not names:
        raise ValueError(f"no node matches {pattern}")
    uris = [master.lookupNode(name)[2] for name in names]
    return [xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())[2] for uri in uris]
