#!/usr/bin/env python3
"""From the separation monitor's trip to standstill, through all nodes and topics: how far each robot that drives goes on.

    rostest --text sylph_bringup emergency_stop.test

prints a line for each. Where robots are is the simulator's truth, by stamps of the lab's time, so that the figures are the same
on any load.
"""
import math
import sys
import time
import unittest

import rospy
import rostest
import yaml
from sylph_msgs.msg import AdgState, SeparationState, SimulationTruth
from sylph_msgs.srv import InjectFault

DEADLINE_S = 200.0  # of the wall
DRIVES_MPS = 0.2
STANDS_MPS = 0.005
LEAST_DRIVING = 6  # of eight; before so many drive the monitor is given no reason to trip
SAME_ROW_M = 0.05  # y may differ so much between the robot that is shown elsewhere and the one there
JUMP_S = 0.5
REST_S = 1.0  # lab time after which all have to stand
# Bases drive up to this much faster than they are told.
FASTER = 1.02


class Reckoned:
    """What the monitor reckons with from a trip to standstill."""

    def __init__(self):
        monitor = "sylph/sylph_separation_monitor/"
        with open(rospy.get_param("sylph/experiment"), encoding="utf-8") as stream:
            execution = yaml.safe_load(stream)["execution"]
        self.speed_limit_mps = execution["speed_limit_mps"]
        self.delay_s = execution["command_latency_s"] + rospy.get_param(monitor + "stop_response_s")
        self.deceleration_mps2 = rospy.get_param(monitor + "stop_deceleration_mps2")

    def distance_m(self, speed_mps):
        return speed_mps * (self.delay_s + speed_mps / (2.0 * self.deceleration_mps2))


class EmergencyStopTest(unittest.TestCase):
    def setUp(self):
        self.truths = []
        self.trip_s = None
        self.mode = None
        self.inject = rospy.ServiceProxy("sylph/inject_fault", InjectFault)
        for topic, kind, handle in [("simulation_truth", SimulationTruth, self.truths.append),
                                    ("separation", SeparationState, self.on_separation),
                                    ("adg_state", AdgState, self.on_state)]:  # fmt: skip
            rospy.Subscriber("sylph/" + topic, kind, handle, tcp_nodelay=True)

    def on_separation(self, state):
        if state.violated and self.trip_s is None:
            self.trip_s = state.header.stamp.to_sec()

    def on_state(self, state):
        self.mode = state.mode

    def now_s(self):
        return self.truths[-1].header.stamp.to_sec() if self.truths else -math.inf

    def wait(self, condition, what):
        deadline = time.monotonic() + DEADLINE_S
        while not condition():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.002)

    def speeds_mps(self, at):
        """Of each robot in the step that led to a truth."""
        before, after = self.truths[at - 1], self.truths[at]
        duration_s = (after.header.stamp - before.header.stamp).to_sec()
        return [math.hypot(b.x - a.x, b.y - a.y) / duration_s for a, b in zip(before.poses, after.poses)]

    def all_drive(self):
        return len(self.truths) > 1 and sum(speed > DRIVES_MPS for speed in self.speeds_mps(-1)) >= LEAST_DRIVING

    def show_one_inside_another(self):
        """The cameras are made to see a robot where another one is; whether there are two in a row of the map."""
        truth = self.truths[-1]
        pairs = [(abs(b.x - a.x), name, b.x - a.x) for name, a in zip(truth.robots, truth.poses) for b in truth.poses
                 if a is not b and abs(b.y - a.y) < SAME_ROW_M]  # fmt: skip
        if not pairs:
            return False
        _, name, offset_m = min(pairs)
        answer = self.inject("jump", [name], 0.0, JUMP_S, offset_m)
        self.assertTrue(answer.success, answer.message)
        return True

    def trip(self):
        deadline = time.monotonic() + DEADLINE_S
        while self.trip_s is None:
            self.assertLess(time.monotonic(), deadline, "the monitor did not trip")
            self.wait(self.all_drive, "robots do not drive")
            if self.show_one_inside_another():
                injected_s = self.now_s()
                self.wait(lambda: self.trip_s is not None or self.now_s() > injected_s + 2.0 * JUMP_S, "the lab stands still")

    def test_every_robot_stands_within_what_the_monitor_reckons_with(self):
        reckoned = Reckoned()
        self.trip()
        self.wait(lambda: self.now_s() > self.trip_s + REST_S, "the lab stands still")
        # By stamps: messages of different nodes may come in another order.
        first = next(at for at, truth in enumerate(self.truths) if truth.header.stamp.to_sec() >= self.trip_s)
        speeds = self.speeds_mps(first)
        driving = [robot for robot, speed in enumerate(speeds) if speed > STANDS_MPS]
        self.assertGreaterEqual(len(driving), LEAST_DRIVING // 2, "they had stopped before the trip")
        most_m = reckoned.distance_m(FASTER * reckoned.speed_limit_mps)
        print(f"\nreckoned: {1e3 * most_m:.1f} mm\nrobot        at the trip [m/s]  went on [mm]      [s]")
        for robot in driving:
            distance_m, stands_s = 0.0, None
            for at in range(first + 1, len(self.truths)):
                a, b = self.truths[at - 1].poses[robot], self.truths[at].poses[robot]
                distance_m += math.hypot(b.x - a.x, b.y - a.y)
                if self.speeds_mps(at)[robot] < STANDS_MPS:
                    stands_s = self.truths[at].header.stamp.to_sec() - self.trip_s
                    break
            name = self.truths[0].robots[robot]
            self.assertIsNotNone(stands_s, f"{name} still moves {REST_S} s after the trip")
            print(f"{name:<12} {speeds[robot]:17.3f} {1e3 * distance_m:13.1f} {stands_s:8.2f}")
            self.assertLess(distance_m, most_m, name)
        self.assertTrue(all(speed < STANDS_MPS for speed in self.speeds_mps(len(self.truths) - 1)))
        self.wait(lambda: self.mode == AdgState.STOP, "the central node does not stop")
        self.assertEqual(0, self.truths[-1].collisions)


if __name__ == "__main__":
    rospy.init_node("emergency_stop_test")
    rostest.rosrun("sylph_bringup", "emergency_stop", EmergencyStopTest, sys.argv)
