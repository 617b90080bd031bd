#!/usr/bin/env python3
"""What the READMEs tell an operator to type while a lab runs, typed as it stands there."""
import importlib.machinery
import importlib.util
import os
import subprocess
import sys
import tempfile
import time
import unittest

import roslib.packages
import rospy
import rostest
from sylph_msgs.msg import AdgState

PACKAGE = "sylph_bringup"
ROOT = os.path.dirname(os.path.dirname(os.path.realpath(roslib.packages.get_pkg_dir(PACKAGE))))
DEADLINE_S = 120.0
COMMAND_S = 60.0
MODES = {"run": AdgState.RUN, "pause": AdgState.PAUSE, "stop": AdgState.STOP}
# In this order: the command, its exit status, what it says, and the lab's mode from then on.
WHILE_A_MISSION_RUNS = [
    ("rosservice call /sylph/stop", 0, "success: True", "stop"),
    ("rosrun sylph_robot_node sylph_confirm_pose robot_3", 1, "nothing is wrong with its pose", "stop"),
    ("rosrun sylph_adg_central sylph_resume", 0, "", "run"),
    ("rosrun sylph_adg_central sylph_stop", 0, "", "stop"),
    ("rosservice call /sylph/resume", 0, "success: True", "run"),
    ("rosrun sylph_adg_central sylph_pause", 0, "", "pause"),
    ("rosrun sylph_adg_central sylph_resume", 0, "", "run"),
    ("rostopic echo /diagnostics", 0, 'name: "', "run"),
]
WHEN_IT_HAS_ENDED = [
    ("rosrun sylph_planner_node sylph_send --plan-only robot_1:=4,7", 0, "nothing has been moved", "run"),
    ("rosrun sylph_planner_node sylph_send --save corner.yaml robot_1:=4,7", 0, "corner.yaml is written", "run"),
    ("rosrun sylph_planner_node sylph_send robot_1:=4,7 robot_6:=0,2", 0, "SUCCESS", "run"),
    ('rosservice call /sylph/inject_fault "{kind: stuck, robots: [robot_0], duration_s: 5.0}"', 0, "success: True", "run"),
]
# What would go on until Ctrl-C, and how it ends by itself.
ENDLESS = {"rostopic echo /diagnostics": "rostopic echo -n1 /diagnostics"}
OTHER_LABS = {
    "rosrun tf tf_monitor /tf:=/lab/tf /tf_static:=/lab/tf_static",  # a fleet in a namespace
    "rostopic pub -1 /replay/sylph/replay_seek std_msgs/Float64 30.0",  # a replay
}


def commands_for_a_lab():
    """Those of the READMEs that scripts/check_commands leaves out because they need one."""
    loader = importlib.machinery.SourceFileLoader("check_commands", os.path.join(ROOT, "scripts", "check_commands"))
    script = importlib.util.module_from_spec(importlib.util.spec_from_loader("check_commands", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(script)
    texts = {text for name in script.markdown_files() for _, text in script.commands(script.ROOT / name)}
    return {text for text in texts if script.needs_a_lab(text)}


class OperatorCommandsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.state = None
        rospy.Subscriber("/sylph/adg_state", AdgState, self.on_state)

    def on_state(self, state):
        self.state = state

    def wait(self, condition, what):
        deadline = time.monotonic() + DEADLINE_S
        while not (self.state and condition(self.state)):
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.02)

    def type(self, command, status, said, mode):
        with self.subTest(command=command):
            typed = subprocess.run(ENDLESS.get(command, command), shell=True, cwd=self.folder, text=True, check=False,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=COMMAND_S)  # fmt: skip
            self.assertEqual(status, typed.returncode, typed.stdout)
            self.assertIn(said, typed.stdout)
            self.wait(lambda state: state.mode == MODES[mode], mode)

    def test_what_an_operator_types_works(self):
        typed = {command for command, *_ in WHILE_A_MISSION_RUNS + WHEN_IT_HAS_ENDED}
        self.assertEqual(set(), commands_for_a_lab() - typed - OTHER_LABS, "of the READMEs, and not typed here")
        self.wait(lambda state: state.phase == AdgState.EXECUTING, "a mission is under way")
        for command in WHILE_A_MISSION_RUNS:
            self.type(*command)
        self.wait(lambda state: state.phase == AdgState.FINISHED, "it ends")
        for command in WHEN_IT_HAS_ENDED:
            self.type(*command)
        self.assertTrue(os.path.isfile(os.path.join(self.folder, "corner.yaml")))


if __name__ == "__main__":
    rospy.init_node("operator_commands_test")
    rostest.rosrun(PACKAGE, "operator_commands", OperatorCommandsTest)
