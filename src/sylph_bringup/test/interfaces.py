"""Compares the tables of topics and services in the READMEs with what nodes publish, subscribe to and serve.

A table stands below a line

    <!-- interface: NODE -->

with the node's name as seen from the fleet's namespace, as are the names in the table; `<robot>/NODE` is one that each robot has. Columns
are name, type, kind and meaning. The kind begins with `publishes`, `subscribes`, `action server`, `service` or `calls`; where it goes on
with `while`, `with` or `without`, the node does so at times.
"""
import os
import re

import roslib.packages

PACKAGES = ["sylph_adg_central", "sylph_mocap_bridge", "sylph_planner_node", "sylph_robot_node", "sylph_rviz", "sylph_sim"]
TABLE = re.compile(r"<!-- interface: (\S+) -->\n\|.*\n\|[-|]+\n((?:\|.*\n)+)")
ACTION = {"goal": "ActionGoal", "cancel": None, "status": None, "feedback": "ActionFeedback", "result": "ActionResult"}
# What each node of ROS has, and what joins nodes in lock step, see the README of sylph_sim.
ALWAYS = re.compile(r".*/(rosout|clock|lock_step/.*|get_loggers|set_logger_level|tf2_frames)$")


class Entry:
    """A row: what a node does with one name."""

    def __init__(self, name, type_name, kind):
        self.name, self.type, self.kind = name, type_name, kind
        self.is_always = not re.search(r"\b(while|with|without)\b", kind)


def tables():
    """(node, entries) of all READMEs."""
    for package in PACKAGES:
        with open(os.path.join(roslib.packages.get_pkg_dir(package), "README.md"), encoding="utf-8") as file:
            text = file.read()
        found = TABLE.findall(text)
        assert found, f"{package}/README.md has no table of topics"
        for node, rows in found:
            yield node, [entry for row in rows.splitlines() for entry in entries_of(row)]


def entries_of(row):
    names, type_cell, kind, _ = (cell.strip() for cell in row.strip("|").split(" | ", 3))
    type_name = type_cell.strip("`") if type_cell.startswith("`") else None
    for name in re.findall(r"`([^`]+)`", names):
        if kind.startswith("action server"):
            for part, suffix in ACTION.items():
                direction = "subscribes" if part in ("goal", "cancel") else "publishes"
                yield Entry(f"{name}/{part}", type_name + suffix if suffix else None, direction)
        else:
            yield Entry(name, type_name, kind)


class Interfaces:
    """What the nodes of one fleet were seen to do, by the master."""

    def __init__(self, namespace, robots):
        self.namespace, self.robots = namespace, robots
        self.seen = {"publishes": {}, "subscribes": {}, "service": {}}  # kind -> node -> names
        self.types = {}

    def note(self, state, types):
        """Takes what the master says in getSystemState() and getTopicTypes()."""
        for kind, users in zip(("publishes", "subscribes", "service"), state):
            for name, nodes in users:
                for node in nodes:
                    self.seen[kind].setdefault(node, set()).add(name)
        self.types.update(types)

    def absolute(self, name, robot):
        if name.startswith("/"):
            return name
        return f"/{self.namespace}/" + name.replace("<robot>", robot or "")

    def findings(self):
        """What tables and nodes say differently, one text each."""
        for node, entries in tables():
            for robot in self.robots if node.startswith("<robot>/") else [None]:
                yield from self.findings_of(self.absolute(node, robot), robot, entries)

    def findings_of(self, node, own_robot, entries):
        told = {kind: set() for kind in self.seen}
        for entry in entries:
            kind = entry.kind.split(" ")[0].rstrip(",")
            robots = self.robots if "<robot>" in entry.name and own_robot is None else [own_robot]
            for robot in robots:
                name = self.absolute(entry.name, robot)
                if kind == "calls":
                    if name not in set().union(*self.seen["service"].values()):
                        yield f"{node}: calls {name}, which no node serves"
                    continue
                pattern = re.compile(re.sub(r"<\w+>", "[^/]+", name) + "$")
                names = {seen for seen in self.seen[kind].get(node, ()) if pattern.match(seen)}
                told[kind] |= names
                if not names and entry.is_always:
                    yield f"{node}: does not do what its README says: {entry.kind} {name}"
                for found in names if kind != "service" and entry.type else ():
                    if self.types.get(found) != entry.type:
                        yield f"{node}: {found} is of type {self.types.get(found)}, in its README {entry.type}"
        for kind, names in told.items():
            for name in sorted(self.seen[kind].get(node, set()) - names):
                if not ALWAYS.match(name):
                    yield f"{node}: {kind} {name}, of which its README says nothing"
