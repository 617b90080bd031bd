#!/usr/bin/env python3
"""record_run waits for the run's folder, records, and closes the bag when it is interrupted."""
import os
import signal
import subprocess
import tempfile
import time
import unittest

import rosbag
import rospy
import rostest
from geometry_msgs.msg import Twist
from sylph_msgs.msg import AdgState
from sylph_ros.programs import find_program
from visualization_msgs.msg import MarkerArray

RECORD = find_program("sylph_record", "record_run")
DEADLINE_S = 30.0


def wait_until(condition):
    deadline = time.monotonic() + DEADLINE_S
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.05)
    return condition()


class RecordTest(unittest.TestCase):
    def record(self, namespace, *options, then=lambda folder: None):
        """The topics of a bag of the fleet in this namespace, while two fleets speak: name -> number of messages."""
        fleet = {"ROS_NAMESPACE": namespace} if namespace else {}
        prefix = f"/{namespace}" if namespace else ""
        state = rospy.Publisher(prefix + "/sylph/adg_state", AdgState, queue_size=10)
        command = rospy.Publisher(prefix + "/cf1/cmd_vel", Twist, queue_size=10)
        rospy.Publisher(prefix + "/sylph/markers/robots", MarkerArray, queue_size=1)
        rospy.Publisher("/other/cf1/cmd_vel", Twist, queue_size=1)
        rospy.set_param(prefix + "/sylph/run_folder", "")
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "run"))
            with open(os.path.join(folder, "run", "result.yaml"), "w", encoding="utf-8") as file:
                file.write("success: true\n")
            recorder = subprocess.Popen([RECORD, *options], env=dict(os.environ, **fleet))
            try:
                rospy.set_param(prefix + "/sylph/run_folder", os.path.join(folder, "run"))
                publishers = (state, command)
                self.assertTrue(wait_until(lambda: all(p.get_num_connections() for p in publishers)))
                rate = rospy.Rate(50)
                for _ in range(50):
                    state.publish(AdgState())
                    command.publish(Twist())
                    rate.sleep()
            finally:
                recorder.send_signal(signal.SIGINT)
                recorder.wait(DEADLINE_S)
            path = os.path.join(folder, "run", "run.bag")
            self.assertFalse(os.path.exists(path + ".active"))
            with rosbag.Bag(path) as bag:
                topics = bag.get_type_and_topic_info().topics
            then(os.path.join(folder, "run"))
            return {name: topic.message_count for name, topic in topics.items()}

    def test_records_inputs_and_decisions_into_the_run_folder_and_closes_the_bag(self):
        topics = self.record("")
        self.assertEqual(set(topics), {"/sylph/adg_state", "/cf1/cmd_vel"})
        self.assertGreater(topics["/sylph/adg_state"], 25)

    def test_records_its_own_fleet_alone(self):
        self.assertEqual(set(self.record("lab")), {"/lab/sylph/adg_state", "/lab/cf1/cmd_vel"})

    def test_writes_a_report_once_the_bag_is_closed(self):
        def wait_for_page(folder):
            self.assertTrue(wait_until(lambda: os.path.isfile(os.path.join(folder, "report", "report.html"))))

        self.assertIn("/sylph/adg_state", self.record("", "--report", then=wait_for_page))


if __name__ == "__main__":
    rospy.init_node("record_test")
    rostest.rosrun("sylph_record", "record", RecordTest)
