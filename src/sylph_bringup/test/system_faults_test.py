#!/usr/bin/env python3
"""Eight robots arrive without contact although cameras, a robot and the central node fail on the way."""
import sys
import unittest

import rospy
import rostest
from sylph_faults.cases import check_case, judge
from sylph_faults.watcher import Watcher

CASE = {
    "name": "one after the other",
    "expect": "arrives",
    "faults": [
        {"kind": "lost", "at_s": 2.0, "duration_s": 1.0},
        {"kind": "jump", "robots": ["{busy}"], "at_s": 5.0, "duration_s": 0.5},
        {"kind": "stuck", "robots": ["{near}"], "at_s": 6.0, "duration_s": 2.0},
    ],
    "pauses": [{"node": "{busy}/.*", "at_s": 8.0, "duration_s": 0.5}],
    "kills": [{"node": "sylph/sylph_adg_central", "at_s": 9.0}],
}


class SystemFaultsTest(unittest.TestCase):

    def test_faults_delay_the_robots_but_never_let_them_touch(self):
        check_case(CASE)
        report = Watcher(CASE).watch(wall_limit_s=220.0)
        self.assertEqual("", judge(CASE, report), report)


if __name__ == "__main__":
    rospy.init_node("system_faults_test")
    rostest.rosrun("sylph_bringup", "system_faults", SystemFaultsTest, sys.argv)
