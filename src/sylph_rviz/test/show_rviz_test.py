#!/usr/bin/env python3
"""show_rviz with and without a display, and with an RViz that does not stay alive."""
import os
import subprocess
import tempfile
import unittest

import roslib.packages
import rosunit

PACKAGE = "sylph_rviz"
SHOW_RVIZ = roslib.packages.find_node(PACKAGE, "show_rviz")[0]
DEADLINE_S = 60.0


class ShowRvizTest(unittest.TestCase):
    def show(self, **environment):
        """What it says; its exit status is always 0, since roslaunch would end the lab for another one."""
        inherited = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        ran = subprocess.run([SHOW_RVIZ, "some.rviz"], env=dict(inherited, **environment), stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, text=True, timeout=DEADLINE_S)  # fmt: skip
        self.assertEqual(0, ran.returncode, ran.stderr)
        return ran.stdout.splitlines()

    def stand_in(self, script):
        """The environment of an installed workspace in which this script is RViz, and a file for its notes."""
        workspace = tempfile.TemporaryDirectory()
        self.addCleanup(workspace.cleanup)
        notes = os.path.join(workspace.name, "notes")
        program = os.path.join(workspace.name, "lib", "rviz", "rviz")
        os.makedirs(os.path.dirname(program))
        with open(program, "w", encoding="utf-8") as file:
            file.write(f"#!/bin/sh\nnotes={notes}\n{script}\n")
        os.chmod(program, 0o755)
        with open(os.path.join(workspace.name, ".catkin"), "w", encoding="utf-8"):
            pass  # makes it one
        return {"CMAKE_PREFIX_PATH": workspace.name, "DISPLAY": ":0"}, notes

    def test_a_computer_without_a_display_shows_nothing(self):
        self.assertEqual(["show_rviz: no RViz: DISPLAY is not set"], self.show())

    def test_gives_up_on_a_display_that_is_not_there(self):
        said = self.show(DISPLAY=":8765")
        self.assertEqual("show_rviz: no RViz: it ended 3 times at once on display :8765", said[-1])
        self.assertEqual(4, len(said), said)

    def test_starts_an_rviz_again_that_was_killed(self):
        environment, notes = self.stand_in('echo "$@" >> $notes; [ $(wc -l < $notes) -eq 2 ] || kill -KILL $$')
        self.assertEqual(["show_rviz: RViz ended with status -9: starting it again"], self.show(**environment))
        with open(notes, encoding="utf-8") as file:
            self.assertEqual(["-d some.rviz"] * 2, file.read().splitlines())

    def test_an_rviz_that_was_closed_stays_closed(self):
        environment, notes = self.stand_in("echo shown >> $notes")
        self.assertEqual([], self.show(**environment))
        with open(notes, encoding="utf-8") as file:
            self.assertEqual("shown\n", file.read())


if __name__ == "__main__":
    rosunit.unitrun(PACKAGE, "show_rviz", ShowRvizTest)
