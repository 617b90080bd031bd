#!/usr/bin/env python3
"""In lock step a run depends on its seed and not on the machine, and no node that stands still stops the lab for ever."""
import json
import os
import signal
import tempfile
import time
import unittest

import roslib.packages
import rospy
import rostest
from fleets_test import Fleet
from sylph_faults.watcher import processes_of
from sylph_msgs.msg import SimulationTruth

PACKAGE = "sylph_bringup"
FAULTS = os.path.join(roslib.packages.get_pkg_dir(PACKAGE), "test", "lock_step", "faults.yaml")
ROBOTS = [f"robot_{number}" for number in range(8)]
MOVED_S = 8.0  # of the lab, after which robots are under way
SILENT_S = 5.0  # of the lab, that it goes on without a node
DEADLINE_S = 180.0
IN_LOCK_STEP = ["speed:=max", "record:=false", "search_steps_per_s:=1000"]


def events_of(fleet):
    """The lines of its event log, with stamps from the start of the lab, which is a whole second of the wall."""
    with open(os.path.join(fleet.run_folder, "events.jsonl"), encoding="utf-8") as file:
        events = [json.loads(line) for line in file]
    start_s = int(events[0]["stamp"])
    return [dict(event, stamp=round(event["stamp"] - start_s, 3)) for event in events]


class LockStepTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def start(self, namespace, natnet_port, *arguments):
        fleet = Fleet(namespace, ROBOTS, natnet_port, self.folder)
        fleet.start("lab_random", f"ns:={namespace}", *IN_LOCK_STEP, *arguments)
        self.addCleanup(fleet.end)
        return fleet

    def wait(self, condition, what):
        deadline = time.monotonic() + DEADLINE_S
        while not condition():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.02)

    def test_two_runs_of_a_seed_are_one(self):
        # Side by side, so that they are in each other's way.
        fleets = [self.start("once", 21650, "seed:=1", f"sim_config:={FAULTS}"),
                  self.start("again", 21660, "seed:=1", f"sim_config:={FAULTS}")]  # fmt: skip
        self.wait(lambda: all(fleet.process.poll() is not None for fleet in fleets), "both missions end")
        once, again = map(events_of, fleets)
        self.assertGreater(sum(event["event"] == "done" for event in once), 8 * 3)
        self.assertIn("blind", {event.get("condition") for event in once if event["plan_id"] == 1})
        self.assertEqual(once, again)
        results = [fleet.result() for fleet in fleets]
        self.assertEqual((True, 8, 0), (results[0]["success"], results[0]["arrived"], results[0]["collisions"]))
        self.assertEqual(*results)

    def test_a_node_that_stands_still_stops_no_lab_for_ever(self):
        lab_s = [None, 0.0]  # start and now

        def note(truth):
            lab_s[1] = truth.header.stamp.to_sec()
            lab_s[0] = lab_s[0] or lab_s[1]

        subscriber = rospy.Subscriber("/silent/sylph/simulation_truth", SimulationTruth, note, queue_size=1)
        self.addCleanup(subscriber.unregister)
        fleet = self.start("silent", 21670, "seed:=2")
        self.wait(lambda: lab_s[0] and lab_s[1] - lab_s[0] > MOVED_S, "the robots are under way")
        stopped = processes_of("silent/sylph/mocap_bridge")
        for process in stopped:
            os.kill(process, signal.SIGSTOP)
        try:
            since_s = lab_s[1]
            self.wait(lambda: lab_s[1] - since_s > SILENT_S, "the lab goes on without cameras")
            self.assertIsNone(fleet.process.poll())
        finally:
            for process in stopped:
                os.kill(process, signal.SIGCONT)
        self.wait(lambda: fleet.process.poll() is not None, "the mission ends")
        result = fleet.result()
        self.assertEqual((True, 8, 0), (result["success"], result["arrived"], result["collisions"]))
        # And stamps are right at once: robots are not blind for longer than the cameras were silent.
        changes = [event for event in events_of(fleet) if event.get("plan_id") == 1 and event.get("robot") == "robot_0" and "condition" in event]
        self.assertEqual(["blind", "ok"], [event["condition"] for event in changes])
        self.assertLess(changes[1]["stamp"] - changes[0]["stamp"], SILENT_S + 2.0)


if __name__ == "__main__":
    rospy.init_node("lock_step_test")
    rostest.rosrun(PACKAGE, "lock_step", LockStepTest)
