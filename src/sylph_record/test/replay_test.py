#!/usr/bin/env python3
"""replay_run plays what a picture needs, and moves no robot."""
import os
import signal
import subprocess
import tempfile
import time
import unittest

import rospy
import rostest
import small_run
from geometry_msgs.msg import Twist
from nav_msgs.msg import OccupancyGrid
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Float64
from sylph_msgs.msg import AdgState, JointActions, ReplayExtent
from sylph_ros.programs import find_program
from visualization_msgs.msg import Marker, MarkerArray

REPLAY = find_program("sylph_record", "replay_run")
DEADLINE_S = 40.0


class ReplayTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.bag = os.path.join(folder.name, "run.bag")

    def topics_while_playing(self, **environment):
        """All topics that are published while the bag is played to its end."""
        replay = subprocess.Popen([REPLAY, self.bag, "--exit-when-done"], env=dict(os.environ, **environment))
        published = set()
        deadline = time.monotonic() + DEADLINE_S
        while replay.poll() is None and time.monotonic() < deadline:
            published.update(topic for topic, _ in rospy.get_published_topics())
            time.sleep(0.1)
        self.assertIsNotNone(replay.poll(), "ends with the bag")
        forbidden = [t for t in published if t.rsplit("/", 1)[-1] in ("cmd_vel", "task", "task_report")]
        self.assertEqual(forbidden, [])
        return published

    def test_draws_the_run_and_plays_nothing_that_a_robot_obeys(self):
        small_run.write_bag(self.bag)
        bodies = set()
        rospy.Subscriber("/sylph/markers/robots", MarkerArray, lambda message: bodies.update(
            m.header.frame_id for m in message.markers if m.ns == "body" and m.action == Marker.ADD
        ))  # fmt: skip
        self.assertIn("/robot_0/pose", self.topics_while_playing())
        self.assertEqual(bodies, set(small_run.ROBOTS))

    def test_starts_where_it_is_told_with_the_map_that_the_bag_holds(self):
        small_run.write_bag(self.bag)
        maps, plans, done = [], [], []
        listeners = [
            rospy.Subscriber("/map", OccupancyGrid, lambda message: maps.append((message.info.width, message.info.height))),
            rospy.Subscriber("/sylph/joint_actions", JointActions, lambda message: plans.append(message.plan_id)),
            rospy.Subscriber("/sylph/adg_state", AdgState, lambda message: done.append(message.robots[0].tasks_done)),
        ]
        subprocess.run([REPLAY, self.bag, "--start", "2.5", "--exit-when-done"], timeout=DEADLINE_S, check=True)
        for listener in listeners:
            listener.unregister()
        self.assertEqual(set(maps), {(4, 2)})
        self.assertEqual(plans[0], 1, "it was sent before")
        self.assertEqual(set(done), {2, 3})

    def wait(self, condition, what):
        deadline = time.monotonic() + DEADLINE_S
        while not condition():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.05)

    def test_moves_to_where_it_is_told(self):
        small_run.write_bag(self.bag)
        extents, now = [], [0.0]

        def note(clock):
            now[0] = clock.clock.to_sec() - small_run.START_S

        listeners = [
            rospy.Subscriber("/sylph/replay_extent", ReplayExtent, extents.append),
            rospy.Subscriber("/clock", Clock, note),
        ]
        seek = rospy.Publisher("/sylph/replay_seek", Float64, queue_size=1)
        replay = subprocess.Popen([REPLAY, self.bag, "--rate", "0.02"])  # would need minutes by itself
        try:
            self.wait(lambda: extents and seek.get_num_connections() > 0, "it tells what there is")
            self.assertEqual((small_run.START_S, 4.0), (extents[0].begin.to_sec(), extents[0].length.to_sec()))
            seek.publish(float("nan"))
            for place_s, low_s, high_s in ((3.0, 3.0, 3.9), (1.0, 1.0, 1.9), (1e9, 3.9, 4.1), (-5.0, -0.1, 0.5)):
                seek.publish(place_s)
                self.wait(lambda: low_s <= now[0] <= high_s, f"{place_s} s")
            seek.publish(2.0)
            self.wait(lambda: now[0] >= 2.0, "it is there")
            plan = rospy.wait_for_message("/sylph/joint_actions", JointActions, DEADLINE_S)
            self.assertEqual(1, plan.plan_id, "for those who come now")
            self.assertIsNone(replay.poll())
        finally:
            replay.send_signal(signal.SIGINT)
            self.assertEqual(0, replay.wait(DEADLINE_S))
            for listener in listeners:
                listener.unregister()

    def test_plays_into_its_own_namespace(self):
        small_run.write_bag(self.bag)
        before = {topic for topic, _ in rospy.get_published_topics()}
        played = self.topics_while_playing(ROS_NAMESPACE="replay") - before
        self.assertLessEqual({"/replay/robot_0/pose", "/replay/sylph/adg_state", "/replay/clock", "/replay/diagnostics"}, played)
        self.assertEqual([topic for topic in played if not topic.startswith("/replay/")], [])

    def assert_refused(self, reason, *options):
        result = subprocess.run([REPLAY, self.bag, *options], capture_output=True, text=True, timeout=DEADLINE_S,
                                check=False)  # fmt: skip
        self.assertEqual(result.returncode, 2)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(reason, result.stderr)

    def test_refuses_where_a_live_robot_could_hear_it(self):
        small_run.write_bag(self.bag)
        live = rospy.Publisher("/robot_0/cmd_vel", Twist, queue_size=1)
        self.assert_refused("a live system is on this ROS master")
        live.unregister()

    def test_refuses_a_bag_that_is_missing_broken_or_of_something_else(self):
        self.assert_refused("no such bag")
        with open(self.bag, "w", encoding="utf-8") as file:
            file.write("no bag")
        self.assert_refused("not a readable bag")
        topics = ["/map", "/sylph/joint_actions", "/sylph/adg_state", "/sylph/separation"]
        topics += [f"/{name}/pose" for name in small_run.ROBOTS]
        small_run.write_bag(self.bag, leave_out=topics)
        self.assert_refused("has none of the topics of a run")

    def test_refuses_to_start_outside_of_the_bag(self):
        small_run.write_bag(self.bag)
        for start_s in ("-1", "4.5"):
            self.assert_refused("--start: must be 0 ... 4.0", "--start", start_s)

    def test_refuses_a_bag_of_another_version_of_the_suite(self):
        small_run.write_old_bag(self.bag)
        self.assert_refused("/robot_0/task is sylph_msgs/Task of another version of the suite (sylph_msgs/Cell has no "
                            "'int8 row' any more, ")


if __name__ == "__main__":
    rospy.init_node("replay_test")
    rostest.rosrun("sylph_record", "replay", ReplayTest)
