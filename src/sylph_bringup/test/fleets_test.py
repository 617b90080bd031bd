#!/usr/bin/env python3
"""Two fleets carry out their missions side by side on one ROS master, and one of them is replayed in a third namespace."""
import os
import signal
import subprocess
import tempfile
import time
import unittest

import rosbag
import rosgraph
import roslib.packages
import rospy
import rostest
import yaml
from interfaces import Interfaces
from nav_msgs.msg import OccupancyGrid
from rosgraph_msgs.msg import Clock
from visualization_msgs.msg import MarkerArray

PACKAGE = "sylph_bringup"
EXPERIMENTS = os.path.join(roslib.packages.get_pkg_dir(PACKAGE), "test", "fleets")
SHARED = {"/rosout", "/rosout_agg", "/diagnostics"}  # tools expect one of each, and names in them tell the fleets apart
DEADLINE_S = 200.0


class Fleet:
    """A lab experiment in a namespace of its own, as a user starts it."""

    def __init__(self, namespace, robots, natnet_port, folder):
        self.namespace = namespace
        self.robots = robots
        self.run_folder = os.path.join(folder, f"the run of {namespace}")
        self.arguments = ["rviz:=false", "report:=false", f"natnet_port:={natnet_port}", f"run_folder:={self.run_folder}"]

    def start(self, experiment, *arguments, output=None, **environment):
        """output: a file for all that the terminal would show."""
        command = ["roslaunch", PACKAGE, "lab_experiment.launch", f"experiment:={experiment}"]
        self.process = subprocess.Popen(command + self.arguments + list(arguments), cwd=EXPERIMENTS,
                                        env=dict(os.environ, **environment), stdout=output, stderr=output)  # fmt: skip

    def end(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(60.0)

    def result(self):
        with open(os.path.join(self.run_folder, "result.yaml"), encoding="utf-8") as stream:
            return yaml.safe_load(stream)


def fleet_of(name):
    return name.split("/")[1]


class FleetsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def wait(self, condition, what):
        deadline = time.monotonic() + DEADLINE_S
        while not condition():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.1)

    def test_two_fleets_arrive_without_meeting(self):
        pair = Fleet("pair", ["cf1", "alpha"], 21610, self.folder)
        trio = Fleet("trio", ["cf1", "mule_27", "B"], 21620, self.folder)
        pair.start("pair.yaml", "ns:=pair")
        trio.start(os.path.join(EXPERIMENTS, "trio.yaml"), ROS_NAMESPACE="trio")
        self.addCleanup(trio.end)
        self.addCleanup(pair.end)
        uses = {}  # topic -> nodes
        nodes = set()
        parameters = set()
        interfaces = [Interfaces(fleet.namespace, fleet.robots) for fleet in (pair, trio)]
        origins = []  # of the pair's map, which SLAM has made: of the lab's, and of the mission's
        maps = rospy.Subscriber("/pair/map", OccupancyGrid, lambda grid: origins.append(grid.info.origin.position))
        master = rosgraph.Master("fleets_test")

        def look():
            publishers, subscribers, services = state = master.getSystemState()
            types = master.getTopicTypes()
            for interface in interfaces:
                interface.note(state, types)
            for topic, users in publishers + subscribers:
                uses.setdefault(topic, set()).update(users)
            nodes.update(node for _, users in publishers + subscribers + services for node in users)
            parameters.update(master.getParamNames())

        def have_ended():
            look()
            return pair.process.poll() is not None and trio.process.poll() is not None

        self.wait(have_ended, "both missions end")
        for fleet in (pair, trio):
            self.assertEqual(0, fleet.process.returncode)
            result = fleet.result()
            self.assertEqual((True, len(fleet.robots), 0), (result["success"], result["arrived"], result["collisions"]))
            for robot in fleet.robots:
                self.assertIn(f"/{fleet.namespace}/{robot}/sylph_robot", nodes)
        self.assert_apart(uses, nodes, parameters)
        maps.unregister()
        self.assertEqual({(-0.7, 0.4)}, {(round(origin.x, 6), round(origin.y, 6)) for origin in origins})
        for interface in interfaces:
            self.assertEqual([], list(interface.findings()))
        for fleet in (pair, trio):
            with rosbag.Bag(os.path.join(fleet.run_folder, "run.bag")) as bag:
                topics = set(bag.get_type_and_topic_info().topics)
            self.assertIn(f"/{fleet.namespace}/tf", topics)
            self.assertEqual(set(), {t for t in topics - SHARED if fleet_of(t) != fleet.namespace})
        self.replay(pair)

    def assert_apart(self, uses, nodes, parameters):
        """Every name is in one fleet's namespace, and nobody uses another's."""
        fleets = {"pair", "trio"}
        own = {"/rosout", rospy.get_name()}
        self.assertEqual(set(), {n for n in nodes - own if fleet_of(n) not in fleets})
        for topic, users in uses.items():
            if topic not in SHARED:
                self.assertEqual({fleet_of(topic)}, {fleet_of(user) for user in users - own} or {fleet_of(topic)}, topic)
        roslaunchs = {"/run_id", "/rosdistro", "/rosversion"}
        strange = {p for p in parameters - roslaunchs if fleet_of(p) not in fleets | {"roslaunch", "fleets"}}
        self.assertEqual(set(), strange)

    def replay(self, fleet):
        """Its bag, whose path has spaces, is shown in another namespace, again and again."""
        starts = []  # of the recorded time
        clock = [0.0]

        def note(message):
            if not clock[0] or message.clock.to_sec() < clock[0] - 1.0:
                starts.append(message.clock.to_sec())
            clock[0] = message.clock.to_sec()

        drawn = set()
        subscribers = [
            rospy.Subscriber("/again/clock", Clock, note),
            rospy.Subscriber("/again/sylph/markers/robots", MarkerArray,
                             lambda message: drawn.update(m.header.frame_id for m in message.markers)),
        ]  # fmt: skip
        launch = subprocess.Popen(["roslaunch", PACKAGE, "replay.launch", "bag:=run.bag", "loop:=true", "rate:=8",
                                   "rviz:=false", "ns:=again"], cwd=fleet.run_folder)  # fmt: skip
        try:
            self.wait(lambda: len(starts) >= 3 or launch.poll() is not None, "the bag is played three times")
            self.assertIsNone(launch.poll(), "it goes on")
        finally:
            launch.send_signal(signal.SIGINT)
            launch.wait(60.0)
            for subscriber in subscribers:
                subscriber.unregister()
        self.assertLessEqual(set(fleet.robots), drawn)


if __name__ == "__main__":
    rospy.init_node("fleets_test")
    rostest.rosrun(PACKAGE, "fleets", FleetsTest)
