"""What the suite's Python programs share: how they end, find others, and belong to a fleet."""
import os
import sys

import rosgraph.names
import roslib.packages

# What ROS calls by a global name and each fleet has for itself, as sylph_ros::initNode() has it.
PER_FLEET = ("/clock", "/use_sim_time", "/tf", "/tf_static")
# Regular expression of the topics, below the fleet's namespace, that only a live system has.
LIVE_TOPIC = "[^/]+/(cmd_vel|task|task_report)"


def fail(message):
    """Ends the program with one line and exit status 2: bad input."""
    print(f"{os.path.basename(sys.argv[0])}: {message}", file=sys.stderr)
    sys.exit(2)


def find_program(package, name):
    """Path of a package's executable."""
    found = roslib.packages.find_node(package, name)
    if not found:
        fail(f"executable {package}/{name} not found: is {package} installed?")
    return found[0]


def fleet_namespace():
    """The namespace in which this program runs, with a slash at its end: the fleet's."""
    return rosgraph.names.get_ros_namespace()


def fleet_remappings():
    """Arguments for a node that is no node of ours, so that it has its fleet's clock and frames."""
    fleet = fleet_namespace().rstrip("/")
    return [f"{name}:={fleet}{name}" for name in PER_FLEET] if fleet else []
