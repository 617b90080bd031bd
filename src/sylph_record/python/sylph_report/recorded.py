"""What a bag was recorded by."""
import re

import genpy.dynamic
import roslib.message
from genmsg import MsgGenerationException


def recorded_fleet(topics):
    """The namespace of the fleet that a bag with these topics is of, '/' or such as '/lab/'; None: of no fleet."""
    found = [re.fullmatch("(/|/.+/)sylph/(adg_state|separation|joint_actions)", topic) for topic in topics]
    return next((match.group(1) for match in found if match), None)


def fields_of(message):
    return {f"{kind} {name}" for name, kind in zip(message.__slots__, message._slot_types)}


def differences(type_name, definition):
    """What a message's definition in a bag has otherwise than today's, by message, as a text; empty if only constants differ."""
    try:
        recorded = genpy.dynamic.generate_dynamic(type_name, definition)
    except (MsgGenerationException, genpy.MessageException):
        return ""
    texts = []
    for name, message in sorted(recorded.items()):
        known = roslib.message.get_message_class(name)
        if known is None:
            texts.append(f"{name} is no more")
            continue
        gone = sorted(fields_of(message) - fields_of(known))
        new = sorted(fields_of(known) - fields_of(message))
        texts += [f"{name} has no '{field}' any more" for field in gone]
        texts += [f"{name} has '{field}' now" for field in new]
    return ", ".join(texts)


def changed_type(connections):
    """One line on a message of the suite that a bag has in another version, and what changed; None if there is none.

    Players and readers would refuse such a message by checksum, or misread it. `connections` are a BagReader's.
    """
    for connection in sorted(connections, key=lambda c: c.topic):
        if not connection.type.startswith("sylph_msgs/"):
            continue
        known = roslib.message.get_message_class(connection.type)
        if known is None or known._md5sum != connection.md5sum:
            changes = differences(connection.type, connection.definition)
            return (
                f"{connection.topic} is {connection.type} of another version of the suite"
                f"{f' ({changes})' if changes else ''}: use the version that recorded it"
            )
    return None
