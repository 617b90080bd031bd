"""What the commands of this package share."""
import os
import re
import sys

import rosgraph.names
import roslib.message
import roslib.packages

# What ROS calls by a global name and each fleet has for itself, as sylph_ros::initNode() has it.
PER_FLEET = ("/clock", "/use_sim_time", "/tf", "/tf_static")


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


def recorded_fleet(topics):
    """The namespace of the fleet that a bag with these topics is of, '/' or such as '/lab/'; None: of no fleet."""
    found = [re.fullmatch("(/|/.+/)sylph/(adg_state|separation|joint_actions)", topic) for topic in topics]
    return next((match.group(1) for match in found if match), None)


def changed_type(connections):
    """One line on a message of the suite that a bag has in another version; None if there is none.

    Players and readers would refuse such a message by checksum, or misread it. `connections` are (topic, type, md5sum).
    """
    for topic, type_name, md5sum in sorted(connections):
        if not type_name.startswith("sylph_msgs/"):
            continue
        known = roslib.message.get_message_class(type_name)
        if known is None or known._md5sum != md5sum:
            return (
                f"{topic} is {type_name} of another version of the suite (a plan is one sylph_msgs/JointActions "
                "since 0.1.0): use the version that recorded it"
            )
    return None
