#!/usr/bin/env python3
"""Who comes after a robot was selected is told which one it is."""
import time
import unittest

import rospy
import rostest
from std_msgs.msg import String

PACKAGE = "sylph_rviz"
TOPIC = "sylph/selected_robot"
DEADLINE_S = 30.0


def told_to_a_newcomer(deadline_s):
    """What a node hears on the topic that it has just begun to listen to; None: nothing."""
    while time.monotonic() < deadline_s:
        try:
            return rospy.wait_for_message(TOPIC, String, timeout=1.0).data
        except rospy.ROSException:
            pass
    return None


class SelectedRobotTest(unittest.TestCase):
    def test_the_markers_tell_a_newcomer_what_was_selected_last(self):
        rospy.init_node("selected_robot_test")
        deadline_s = time.monotonic() + DEADLINE_S
        publisher = rospy.Publisher(TOPIC, String, queue_size=1)
        while publisher.get_num_connections() == 0:
            self.assertLess(time.monotonic(), deadline_s, "sylph_markers does not listen")
            time.sleep(0.05)
        publisher.publish("robot_1")
        self.assertEqual("robot_1", told_to_a_newcomer(deadline_s))


if __name__ == "__main__":
    rostest.rosrun(PACKAGE, "selected_robot", SelectedRobotTest)
