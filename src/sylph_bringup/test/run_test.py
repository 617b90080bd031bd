#!/usr/bin/env python3
"""./run, with stand-ins for what it installs, builds and launches."""
import os
import shutil
import subprocess
import tempfile
import unittest

import roslib.packages
import rosunit

PACKAGE = "sylph_bringup"
PACKAGE_ROOT = roslib.packages.get_pkg_dir(PACKAGE)
ROOT = os.path.dirname(os.path.dirname(os.path.realpath(PACKAGE_ROOT)))
FILES = {
    "scripts/environment.sh": """
        die() { echo "run: $*" >&2; exit 2; }
        install_packages() { :; }
        build() { :; }
    """,
    "devel/setup.bash": 'PATH=$PWD/devel:$PATH\n',
    # Keeps its arguments and leaves a run folder and sylph_mission's exit status as $LEAVE and $STATUS say.
    "devel/roslaunch": """#!/usr/bin/env bash
        printf '%s\\n' "$@" > arguments
        for argument in "$@"; do declare "${argument%%:=*}=${argument#*:=}" 2> /dev/null; done
        eval "$LEAVE"
        echo "$STATUS" > "$mission_status"
    """,
}


class RunTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = os.path.join(os.path.realpath(folder.name), "suite")
        self.caller = os.path.join(os.path.realpath(folder.name), "a user's")
        os.mkdir(self.caller)
        for name, text in FILES.items():
            path = os.path.join(self.root, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        os.chmod(os.path.join(self.root, "devel", "roslaunch"), 0o755)
        os.mkdir(os.path.join(self.root, "src"))
        os.symlink(PACKAGE_ROOT, os.path.join(self.root, "src", PACKAGE))
        os.symlink(os.path.join(PACKAGE_ROOT, "launch"), os.path.join(self.root, "launch"))
        shutil.copy(os.path.join(ROOT, "run"), self.root)

    def run_it(self, *arguments, leave=":", status=0):
        environment = dict(os.environ, LEAVE=leave, STATUS=str(status), HOME=self.caller, ROS_HOME=self.caller)
        environment.pop("DISPLAY", None)
        return subprocess.run([os.path.join(self.root, "run"), *arguments], cwd=self.caller, env=environment,
                              capture_output=True, text=True, check=False)  # fmt: skip

    def launched(self):
        """The arguments that roslaunch got: name -> value."""
        with open(os.path.join(self.root, "arguments"), encoding="utf-8") as file:
            return dict(line.split(":=", 1) for line in file.read().splitlines() if ":=" in line)

    def folder_to_resume(self):
        """A run folder with the result that was written when the run was broken off."""
        folder = os.path.join(self.caller, "old")
        os.mkdir(folder)
        for name, text in (("result.yaml", "success: true\n"), ("events.jsonl", '{"phase": "executing"}\n')):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        return folder

    def test_prints_the_result_and_exits_with_it(self):
        for success, status in (("true", 0), ("false", 1)):
            ran = self.run_it(f"run_folder:={success}", leave=f'mkdir "$run_folder"; echo success: {success} > "$run_folder/result.yaml"')
            self.assertEqual(status, ran.returncode, ran.stderr)
            self.assertIn(f"result: {self.caller}/{success}/result.yaml\nsuccess: {success}\n", ran.stdout)

    def test_a_mission_that_failed_is_no_success_whatever_the_result_says(self):
        leave = 'mkdir "$run_folder"; echo success: true > "$run_folder/result.yaml"'
        for status in (1, 2, 137):
            ran = self.run_it(f"run_folder:={status}", leave=leave, status=status)
            self.assertEqual(1, ran.returncode, ran.stderr)
            self.assertIn("success: true\n", ran.stdout)

    def test_takes_no_older_result_for_this_runs(self):
        folder = self.folder_to_resume()
        ran = self.run_it("run_folder:=old")
        self.assertEqual((1, f"run: no result was written to {folder}/result.yaml\n"), (ran.returncode, ran.stderr))
        self.assertNotIn("success", ran.stdout)

    def test_paths_count_from_where_the_user_stands(self):
        for name in ("lab.yaml", "w.safetensors", "mocap.yaml", "sim.yaml"):
            with open(os.path.join(self.caller, name), "w", encoding="utf-8"):
                pass
        paths = {"experiment": "lab.yaml", "weights": "w.safetensors", "mocap_config": "mocap.yaml", "sim_config": "sim.yaml",
                 "run_folder": "r", "mission_status": "status"}  # fmt: skip
        for start in ("", "./", "~/", self.caller + "/"):
            ran = self.run_it(*(f"{name}:={start}{path}" for name, path in paths.items()))
            launched = self.launched()
            self.assertEqual({name: os.path.join(self.caller, path) for name, path in paths.items()},
                             {name: launched.get(name) for name in paths}, ran.stderr)  # fmt: skip
        for name in ("weights", "mocap_config", "sim_config"):
            self.assertIn(f"{self.caller}/no: no such file", self.run_it(f"{name}:=no").stderr)

    def test_a_computer_whose_name_has_no_address_is_localhost(self):
        def named(hostname, **settings):
            environment = {name: value for name, value in os.environ.items() if name not in ("ROS_HOSTNAME", "ROS_IP")}
            environment.update(settings, **{"BASH_FUNC_hostname%%": f"() {{ echo {hostname}; }}"})
            command = '. scripts/environment.sh; echo "${ROS_HOSTNAME:-}"'
            ran = subprocess.run(["bash", "-euc", command, "run"], cwd=ROOT, env=environment,
                                 capture_output=True, text=True, check=True)  # fmt: skip
            return ran.stdout.strip(), ran.stderr

        self.assertEqual(("", ""), named("localhost"))
        self.assertEqual(("", ""), named("renamed.invalid", ROS_IP="192.168.1.5"))
        name, said = named("renamed.invalid")
        self.assertEqual("localhost", name)
        self.assertIn("run: this computer's name, renamed.invalid, has no address", said)

    def test_refuses_a_bad_run_folder_before_it_builds(self):
        folder = self.folder_to_resume()
        with open(os.path.join(folder, "experiment.yaml"), "w", encoding="utf-8") as file:
            file.write("robots: []\n")
        ran = self.run_it("run_folder:=old")
        self.assertEqual(2, ran.returncode)
        self.assertIn(f"run folder {folder}: holds a run of another experiment", ran.stderr)
        self.assertNotIn("building", ran.stdout)


if __name__ == "__main__":
    rosunit.unitrun(PACKAGE, "run", RunTest)
