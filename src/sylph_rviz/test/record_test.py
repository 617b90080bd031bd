#!/usr/bin/env python3
"""record.launch: waits for the run's folder, records, and closes the bag when it is interrupted."""
import os
import signal
import subprocess
import tempfile
import time
import unittest

import rosbag
import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import Twist
from sylph_msgs.msg import AdgState
from visualization_msgs.msg import MarkerArray

LAUNCH = os.path.join(roslib.packages.get_pkg_dir("sylph_rviz"), "../../launch/record.launch")
DEADLINE_S = 30.0


def wait_until(condition):
    deadline = time.monotonic() + DEADLINE_S
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.05)
    return condition()


class RecordTest(unittest.TestCase):
    def test_records_inputs_and_decisions_into_the_run_folder_and_closes_the_bag(self):
        state = rospy.Publisher("/sylph/adg_state", AdgState, queue_size=10)
        command = rospy.Publisher("/robot_0/cmd_vel", Twist, queue_size=10)
        rospy.Publisher("/sylph/markers/robots", MarkerArray, queue_size=1)
        rospy.set_param("/sylph/run_folder", "/an/earlier/run")
        with tempfile.TemporaryDirectory() as folder:
            launch = subprocess.Popen(["roslaunch", LAUNCH])
            try:
                cleared = wait_until(lambda: rospy.get_param("/sylph/run_folder") == "")
                self.assertTrue(cleared, "an earlier run's folder is forgotten")
                rospy.set_param("/sylph/run_folder", os.path.join(folder, "run"))
                publishers = (state, command)
                self.assertTrue(wait_until(lambda: all(p.get_num_connections() for p in publishers)))
                rate = rospy.Rate(50)
                for _ in range(50):
                    state.publish(AdgState())
                    command.publish(Twist())
                    rate.sleep()
            finally:
                launch.send_signal(signal.SIGINT)
                launch.wait(DEADLINE_S)
            path = os.path.join(folder, "run", "run.bag")
            self.assertFalse(os.path.exists(path + ".active"))
            with rosbag.Bag(path) as bag:
                topics = bag.get_type_and_topic_info().topics
            self.assertEqual(set(topics), {"/sylph/adg_state", "/robot_0/cmd_vel"})
            self.assertGreater(topics["/sylph/adg_state"].message_count, 25)


if __name__ == "__main__":
    rospy.init_node("record_test")
    rostest.rosrun("sylph_rviz", "record", RecordTest)
