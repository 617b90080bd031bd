#!/usr/bin/env python3
"""The command sylph_report."""
import os
import subprocess
import tempfile
import unittest

import rosunit
import small_run
import yaml
from PIL import Image
from sylph_report import comparison, rehearsal, run_data
from sylph_ros.programs import find_program

REPORT = find_program("sylph_record", "sylph_report")


def report(*arguments):
    return subprocess.run([REPORT, *arguments], capture_output=True, text=True, check=False)


class ReportTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, *names):
        return os.path.join(self.folder.name, *names)

    def test_writes_a_page_with_all_figures(self):
        small_run.write_folder(self.folder.name)
        result = report(self.folder.name)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(self.path("report", "report.html"), encoding="utf-8") as file:
            page = file.read()
        for figure in ("time_space", "progress", "waiting", "separation", "social", "tracking"):
            self.assertIn(f'src="{figure}.png"', page)
            self.assertGreater(os.path.getsize(self.path("report", f"{figure}.png")), 1000)
        self.assertIn('src="run.gif"', page)
        with Image.open(self.path("report", "run.gif")) as picture:
            self.assertGreater(picture.n_frames, 50)
        self.assertLess(os.path.getsize(self.path("report", "run.gif")), 1e6)
        self.assertIn("min_separation_m", page)
        self.assertIn("mode stop", page)

    def test_leaves_out_the_animation_when_told_so(self):
        small_run.write_folder(self.folder.name)
        self.assertEqual(report(self.folder.name, "--no-animation").returncode, 0)
        self.assertFalse(os.path.exists(self.path("report", "run.gif")))

    def test_compares_two_runs(self):
        folders = [self.path("first"), self.path("second")]
        for folder, result in zip(folders, ("success: true\nexecution_s: 9.0\nrobots: 2\nstops: 0\n",
                                            "success: true\nexecution_s: 7.5\nrobots: 2\nstops: 1\n")):
            os.mkdir(folder)
            small_run.write_folder(folder)
            with open(os.path.join(folder, "result.yaml"), "w", encoding="utf-8") as file:
                file.write(result)
        rows = {row[0]: row[1:] for row in comparison.rows(*map(run_data.load, folders))}
        self.assertEqual(rows["success"], (True, True, None, None))
        self.assertEqual(rows["stops"], (0, 1, 1, 0))
        self.assertEqual(rows["execution_s"], (9.0, 7.5, -1.5, 1))
        self.assertEqual(rows["robots"], (2, 2, 0, None))
        self.assertAlmostEqual(rows["waited [s]: silent"][0], 1.0, places=3)
        result = report("--no-animation", "--compare", *folders)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(result.stdout.strip(), encoding="utf-8") as file:
            page = file.read()
        self.assertIn('<td class="number better">7.5 \u2713</td><td class="number">-1.5</td>', page)
        self.assertIn('src="../../first/report/time_space.png"', page)

    def test_calls_no_failed_run_the_quicker_one(self):
        runs = [run_data.Run("done", result={"success": True, "execution_s": 60.0}),
                run_data.Run("failed", result={"success": False, "execution_s": 5.0})]  # fmt: skip
        self.assertEqual([row[4] for row in comparison.rows(*runs)], [0, None])

    def test_compares_a_run_with_rehearsals_that_finished(self):
        run = run_data.Run("run", result={"execution_ratio": 1.5, "min_separation_m": 0.05})
        figures = {"ideal_execution_s": 10.0, "min_separation_m": 0.05}
        rehearsals = [dict(figures, ending="finished", execution_s=seconds) for seconds in (11.0, 12.0, 13.0)]
        page = rehearsal.table(run, rehearsals + [dict(figures, ending="stopped", execution_s=99.0)])
        self.assertIn("3 of 4 rehearsals finished", page)
        cells = "".join(f'<td class="number">{value}</td>' for value in (1.5, 1.1, 1.2, 1.3))
        self.assertIn(f"<tr><td>execution_ratio</td>{cells}<td>above all</td></tr>", page)
        self.assertIn("within", page)

    def test_rehearses_what_the_bag_holds(self):
        small_run.write_folder(self.folder.name)
        with open(self.path("experiment.yaml"), "w", encoding="utf-8") as file:
            file.write("map: away.map\nrobots: [{name: robot_1}, {name: robot_0, rigid_body: b}]\n"
                       "planning: {planner: lacam, weights: away.safetensors}\n")  # fmt: skip
        run = run_data.load(self.folder.name)
        with open(rehearsal.write_experiment(run, self.folder.name, self.folder.name), encoding="utf-8") as file:
            experiment = yaml.safe_load(file)
        self.assertEqual(experiment["robots"], [
            {"name": "robot_0", "rigid_body": "b", "start": [0, 0], "goal": [0, 3]},
            {"name": "robot_1", "start": [1, 0], "goal": [1, 3]},
        ])  # fmt: skip
        self.assertEqual(experiment["planning"], {"planner": "lacam"})
        with open(self.path(experiment["map"]), encoding="utf-8") as file:
            self.assertEqual(file.read(), "type octile\nheight 2\nwidth 4\nmap\n....\n....\n")

    def test_says_why_it_is_not_compared_with_a_rehearsal(self):
        with open(self.path("result.yaml"), "w", encoding="utf-8") as file:
            file.write("success: false\n")
        result = report(self.folder.name, "--rehearse", "2")
        self.assertEqual(result.returncode, 0)
        self.assertIn("not compared with a rehearsal", result.stderr)

    def test_reports_what_is_there_and_names_in_one_line_what_is_missing(self):
        with open(self.path("result.yaml"), "w", encoding="utf-8") as file:
            file.write("success: false\n")
        result = report(self.folder.name)
        self.assertEqual(result.returncode, 0)
        lines = [line for line in result.stderr.splitlines() if "run.bag" in line]
        self.assertEqual(len(lines), 1)
        self.assertIn("missing", lines[0])
        self.assertTrue(os.path.isfile(self.path("report", "report.html")))

    def test_leaves_out_the_figure_whose_topic_is_missing(self):
        small_run.write_bag(self.path("run.bag"), leave_out=["/sylph/separation"])
        result = report(self.folder.name)
        self.assertEqual(result.returncode, 0)
        self.assertIn("run.bag: has no /sylph/separation", result.stderr)
        self.assertFalse(os.path.exists(self.path("report", "separation.png")))
        self.assertTrue(os.path.exists(self.path("report", "progress.png")))

    def assert_refused(self, result, reason):
        self.assertEqual(result.returncode, 2)
        self.assertNotIn("Traceback", result.stderr)
        self.assertIn(reason, result.stderr)

    def test_refuses_a_folder_without_a_run(self):
        self.assert_refused(report(self.folder.name), "has neither run.bag")
        self.assert_refused(report(), "give either a run folder or --compare with two")
        self.assert_refused(report(self.path("nowhere")), "no such folder")

    def test_says_so_when_files_are_broken(self):
        for name in ("run.bag", "result.yaml", "events.jsonl", "experiment.yaml"):
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write("{ broken: [")
        result = report(self.folder.name)
        self.assert_refused(result, "not a readable bag")
        self.assertIn("not YAML", result.stderr)
        self.assertIn("not an event", result.stderr)

    def test_says_so_when_files_are_of_something_else(self):
        contents = {
            "result.yaml": "success: true",
            "events.jsonl": '["stamp"]',
            "experiment.yaml": "execution: fast",
        }
        for name, content in contents.items():
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write(content)
        result = report(self.folder.name)
        self.assertEqual(result.returncode, 0)
        self.assertIn("events.jsonl:1: not an event", result.stderr)
        self.assertIn("not an experiment", result.stderr)


if __name__ == "__main__":
    rosunit.unitrun("sylph_record", "report", ReportTest)
