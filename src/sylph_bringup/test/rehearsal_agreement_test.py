#!/usr/bin/env python3
"""What the rehearsal says of a mission is what the same mission then does through all nodes and topics."""
import json
import os
import re
import subprocess
import tempfile
import unittest

import roslib.packages
import rostest
import yaml
from fleets_test import Fleet

PACKAGE = "sylph_bringup"
SEED = 3
ROBOTS = [f"robot_{number}" for number in range(8)]
# Makes one plan a seed, however long it may take: both ends plan the same.
PLANNER = "pibt"
TIME_SHARE = 0.03  # by which execution times may differ
ORDER_S = 0.5  # within which two robots may end their tasks in another order
DEADLINE_S = 400.0
TROUBLE = re.compile(r"\[(?: WARN|ERROR|FATAL)\]|\[(?:WARN|ERROR|FATAL)\] ")


def done_at(path):
    """(robot, sequence) of each task to the time at which the central node knew that it was done, from the plan's start."""
    with open(path, encoding="utf-8") as file:
        events = [json.loads(line) for line in file]
    start_s = next(event["stamp"] for event in events if event["event"] == "plan")
    return {(event["robot"], event["sequence"]): event["stamp"] - start_s for event in events if event["event"] == "done"}


class RehearsalAgreementTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def rehearse(self):
        """Result and event log of the rehearsed mission."""
        maps = os.path.join(roslib.packages.get_pkg_dir(PACKAGE), "maps")
        with open(os.path.join(maps, "lab_random.yaml"), encoding="utf-8") as stream:
            experiment = yaml.safe_load(stream)
        experiment["map"] = os.path.join(maps, experiment["map"])
        experiment["planning"]["planner"] = PLANNER
        path = os.path.join(self.folder, "experiment.yaml")
        with open(path, "w", encoding="utf-8") as stream:
            yaml.safe_dump(experiment, stream)
        logs = os.path.join(self.folder, "logs")
        command = ["rosrun", "sylph_rehearsal", "sylph_rehearse", path, "--seeds", str(SEED), "--json", "--event-logs", logs]
        run = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["runs"][0]
        return run, done_at(os.path.join(logs, f"{SEED}.jsonl"))

    def test_time_and_order_are_those_of_the_rehearsal(self):
        rehearsed, expected = self.rehearse()
        self.assertEqual("finished", rehearsed["ending"])
        fleet = Fleet("rehearsed", ROBOTS, 21680, self.folder)
        terminal = os.path.join(self.folder, "terminal")
        with open(terminal, "w", encoding="utf-8") as output:
            fleet.start("lab_random", "ns:=rehearsed", f"seed:={SEED}", f"planner:={PLANNER}", "speed:=max", "record:=false", output=output)
            self.addCleanup(fleet.end)
            self.assertEqual(0, fleet.process.wait(DEADLINE_S))
        with open(terminal, encoding="utf-8", errors="replace") as stream:
            lines = stream.read().splitlines()
        self.assertIn("SUCCESS", "".join(lines))
        # Nothing went wrong: not before the first poses, and not while everything goes down.
        self.assertEqual([], [line for line in lines if TROUBLE.search(line)])
        result = fleet.result()
        done = done_at(os.path.join(fleet.run_folder, "events.jsonl"))
        self.assertGreater(len(done), len(ROBOTS))
        self.assertEqual(set(expected), set(done))
        print("execution:", rehearsed["execution_s"], "rehearsed,", result["execution_s"], "s in the nodes")
        self.assertLess(abs(result["execution_s"] / rehearsed["execution_s"] - 1.0), TIME_SHARE)
        order = sorted(expected, key=expected.get)
        for index, task in enumerate(order):
            for other in order[index + 1 :]:
                if expected[other] - expected[task] > ORDER_S:
                    self.assertLess(done[task], done[other], f"{task} before {other}")


if __name__ == "__main__":
    rostest.rosrun(PACKAGE, "rehearsal_agreement", RehearsalAgreementTest)
