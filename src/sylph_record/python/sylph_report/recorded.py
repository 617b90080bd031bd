"""What a bag was recorded by."""
import re

import roslib.message


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
