#!/usr/bin/env python3
"""What the report reads from a run folder."""
import os
import tempfile
import unittest

import rosbag
import rosunit
import small_run
from sylph_report import figures, run_data
from sylph_report.bag_reader import BagReader


class RunDataTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        small_run.write_folder(self.folder.name)
        self.run_data = run_data.load(self.folder.name)

    def test_counts_cells_from_the_first_task_on(self):
        robot = self.run_data.robots["robot_0"]
        self.assertAlmostEqual(robot.time_s[0], 0.0)
        self.assertEqual(robot.cells_done[0], 0)
        self.assertEqual(robot.cells_done[-1], 3)

    def test_spreads_the_plan_over_its_shortest_time(self):
        robot = self.run_data.robots["robot_1"]
        self.assertEqual(robot.planned_cells, [0, 1, 2, 3])
        for planned_s, expected_s in zip(robot.planned_time_s, [0.0, 1.0, 2.0, 3.0]):
            self.assertAlmostEqual(planned_s, expected_s)

    def test_sums_waits_by_cause_and_not_by_its_details(self):
        self.assertEqual(run_data.waiting_by_cause(self.run_data.robots["robot_0"]), {})
        causes = run_data.waiting_by_cause(self.run_data.robots["robot_1"])
        self.assertEqual(list(causes), [("robot_0", "silent")])
        self.assertAlmostEqual(causes[("robot_0", "silent")], 1.0, places=3)

    def test_groups_causes_by_kind(self):
        kinds = {
            "no good pose: pose is 0.31 s old by its stamp": "no good pose",
            "no good pose: no good pose for 2.0 s": "no good pose",
            "no good pose": "no good pose",
            "is on its way from (10,8) to (10,7)": "is on its way",
            "no report for 3.1 s": "no report",
            "no report yet": "no report",
            "no progress for 5.0 s: held by the user": "no progress",
            "stop: by the user": "stopped",
            "its next task is not released yet": "its next task is not released",
            "rests at the commit cut until the rest is planned anew": "rests at the commit cut until the rest is planned anew",
        }
        self.assertEqual({text: run_data.cause_kind(text) for text in kinds}, kinds)

    def test_takes_progress_from_the_event_log_when_there_is_no_bag(self):
        os.remove(os.path.join(self.folder.name, "run.bag"))
        robot = run_data.load(self.folder.name).robots["robot_1"]
        self.assertEqual(robot.cells_done, [0, 1, 2, 3])
        self.assertEqual(robot.time_s, [0.0, 1.0, 2.0, 3.0])

    def test_says_in_one_line_that_a_bag_is_of_another_version(self):
        small_run.write_old_bag(os.path.join(self.folder.name, "run.bag"))
        missing = run_data.load(self.folder.name).missing
        self.assertEqual(len(missing), 1)
        self.assertIn(
            "/robot_0/task is sylph_msgs/Task of another version of the suite (sylph_msgs/Cell has no 'int8 row' any "
            "more, sylph_msgs/Cell has 'int32 row' now, sylph_msgs/Task has no 'uint16 tasks' any more, sylph_msgs/Task "
            "has 'uint32 robot_tasks' now): use the version that recorded it",
            missing[0],
        )

    def test_reads_what_rosbag_reads(self):
        path = os.path.join(self.folder.name, "run.bag")
        for compression in ("none", "bz2", "lz4"):
            small_run.write_bag(path, compression=compression)
            topics = ["/sylph/adg_state", "/robot_1/task_report"]
            with rosbag.Bag(path) as bag:
                expected = [(topic, raw[1]) for topic, raw, _ in bag.read_messages(topics=topics, raw=True)]
            self.assertEqual(sorted(message[1:] for message in BagReader(path).read(topics)), sorted(expected))

    def test_reads_the_tracking_error_from_the_end_of_a_report(self):
        for name, error_m in (("robot_0", 0.002), ("robot_1", 0.004)):
            self.assertEqual(set(self.run_data.robots[name].tracking_error_m), {error_m})

    def test_knows_the_map_and_where_robots_were(self):
        for corner_m in ((0.0, 0.0), (-10.0, 5.0)):
            small_run.write_bag(os.path.join(self.folder.name, "run.bag"), corner_m=corner_m)
            run = run_data.load(self.folder.name)
            self.assertEqual(run.obstacles, [[False] * 4] * 2)
            time_s, row, column, _ = figures.cells_of(run, run.robots["robot_1"])
            self.assertAlmostEqual(time_s[0], 0.0)
            for values, expected in ((row, (1.0, 1.0)), (column, (0.0, 3.0))):
                self.assertAlmostEqual(values[0], expected[0])
                self.assertAlmostEqual(values[-1], expected[1])

    def test_names_robots_by_what_tells_them_apart(self):
        self.assertEqual(figures.short_names(["robot_1", "robot_10"]), {"robot_1": "1", "robot_10": "10"})
        self.assertEqual(figures.short_names(["cf1"]), {"cf1": "cf1"})

    def test_refuses_a_bag_that_is_cut_or_not_closed(self):
        path = os.path.join(self.folder.name, "run.bag")
        with open(path, "rb") as file:
            content = file.read()
        for size in (0, 5, 100, len(content) // 2):
            with open(path, "wb") as file:
                file.write(content[:size])
            self.assertIn("not a readable bag", run_data.load(self.folder.name).missing[0])

    def test_says_nothing_is_missing(self):
        self.assertEqual(self.run_data.missing, [])


if __name__ == "__main__":
    rosunit.unitrun("sylph_record", "run_data", RunDataTest)
