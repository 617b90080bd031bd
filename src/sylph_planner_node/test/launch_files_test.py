#!/usr/bin/env python3
"""Loads each launch file of the suite as roslaunch does and looks at what it would start."""
import glob
import itertools
import os
import unittest
import xml.etree.ElementTree

import roslaunch.config
import roslaunch.xmlloader
import roslib.packages
import rosunit
import yaml

PACKAGE = "sylph_planner_node"
ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../.."))
LAB = os.path.join(ROOT, "launch", "lab_experiment.launch")
SIMULATION = {"sylph_sim"}
ALWAYS = {
    "mocap_bridge",
    "sylph_adg_central",
    "sylph_separation_monitor",
    "sylph_planner",
    "sylph_markers",
    "sylph_mission",
}


def load(path, **arguments):
    """The configuration that roslaunch makes of a file."""
    config = roslaunch.config.ROSLaunchConfig()
    argv = ["{}:={}".format(name, value) for name, value in arguments.items()]
    roslaunch.xmlloader.XmlLoader(resolve_anon=False).load(path, config, argv=argv, verbose=False)
    return config


def arguments_of(path):
    """The <arg> elements of a file that its caller may set."""
    elements = xml.etree.ElementTree.parse(path).getroot().findall("arg")
    return [element for element in elements if "value" not in element.attrib]


def launch_files():
    return sorted(glob.glob(os.path.join(ROOT, "launch", "*.launch")))


def node_names(config):
    return {node.name for node in config.nodes}


def robots_of(config):
    return sorted(node.namespace.strip("/") for node in config.nodes if node.name == "sylph_robot")


def value_of(config, parameter):
    return config.params[parameter].value


class LaunchFilesTest(unittest.TestCase):
    def test_every_file_loads_and_its_nodes_exist(self):
        for path in launch_files():
            with self.subTest(path=path):
                required = [arg.get("name") for arg in arguments_of(path) if "default" not in arg.attrib]
                config = load(path, **{name: "1" for name in required})
                self.assertTrue(config.nodes)
                for node in config.nodes:
                    found = roslib.packages.find_node(node.package, node.type)
                    self.assertTrue(found, "{}/{}".format(node.package, node.type))

    def test_every_argument_has_a_description(self):
        for path in launch_files():
            for argument in arguments_of(path):
                self.assertTrue(argument.get("doc"), "{}: {}".format(path, argument.get("name")))

    def test_every_combination_of_switches_starts_the_right_nodes(self):
        switches = ["sim", "rviz", "record", "exit_when_done"]
        for values in itertools.product(["true", "false"], repeat=len(switches)):
            chosen = dict(zip(switches, values))
            with self.subTest(**chosen):
                config = load(LAB, robots=0, **chosen)
                expected = set(ALWAYS)
                expected |= SIMULATION if chosen["sim"] == "true" else set()
                expected |= {"rviz"} if chosen["rviz"] == "true" else set()
                expected |= {"record_run"} if chosen["record"] == "true" else set()
                self.assertEqual(expected, node_names(config))
                exits = value_of(config, "/sylph/sylph_mission/exit_when_done")
                self.assertEqual(chosen["exit_when_done"] == "true", exits)

    def test_starts_one_node_for_each_robot(self):
        for count in [0, 1, 8, 20]:
            with self.subTest(count=count):
                expected = sorted("robot_{}".format(index) for index in range(count))
                self.assertEqual(expected, robots_of(load(LAB, robots=count)))

    def test_starts_as_many_robots_as_the_lab_experiments_have(self):
        files = glob.glob(os.path.join(ROOT, "maps", "lab_*.yaml"))
        self.assertTrue(files)
        for path in files:
            with open(path, encoding="utf-8") as stream:
                robots = sorted(robot["name"] for robot in yaml.safe_load(stream)["robots"])
            self.assertEqual(robots, robots_of(load(LAB, experiment=path)), path)

    def test_every_node_of_ours_gets_the_same_experiment_and_seed(self):
        config = load(LAB, experiment="maps/lab_room.yaml", seed=7, rviz="false", record="false")
        expected = os.path.join(ROOT, "maps/lab_room.yaml")
        for node in config.nodes:
            prefix = node.namespace + node.name + "/"
            path = os.path.realpath(value_of(config, prefix + "experiment"))
            self.assertEqual(expected, path, prefix)
            self.assertEqual(7, value_of(config, prefix + "seed"), prefix)

    def test_takes_an_absolute_path_as_it_is(self):
        config = load(LAB, experiment="/somewhere/lab.yaml")
        self.assertEqual(
            "/somewhere/lab.yaml", value_of(config, "/sylph/sylph_planner/experiment")
        )

    def test_weights_are_found_from_the_root_of_the_suite(self):
        for node in ["sylph_planner", "sylph_mission"]:
            parameter = "/sylph/{}/weights".format(node)
            self.assertEqual("", value_of(load(LAB), parameter))
            found = value_of(load(LAB, weights="weights/w.safetensors"), parameter)
            self.assertEqual(os.path.join(ROOT, "weights/w.safetensors"), os.path.realpath(found))
            self.assertEqual("/w.safetensors", value_of(load(LAB, weights="/w.safetensors"), parameter))

    def test_real_robots_know_no_speed_factor(self):
        simulated = load(LAB, speed=4)
        self.assertTrue(value_of(simulated, "/use_sim_time"))
        self.assertEqual(4.0, value_of(simulated, "/sylph/speed"))
        real = load(LAB, speed=4, sim="false")
        self.assertFalse(value_of(real, "/use_sim_time"))
        self.assertEqual(1.0, value_of(real, "/sylph/speed"))

    def test_simulated_cameras_and_bridge_speak_on_the_same_ports(self):
        config = load(LAB, natnet_port=2000)
        self.assertEqual(2000, value_of(config, "/sylph/sylph_sim/natnet/command_port"))
        self.assertEqual(2001, value_of(config, "/sylph/sylph_sim/natnet/data_port"))
        self.assertEqual(2000, value_of(config, "/sylph/mocap_bridge/command_port"))
        self.assertEqual(2001, value_of(config, "/sylph/mocap_bridge/data_port"))


if __name__ == "__main__":
    rosunit.unitrun(PACKAGE, "launch_files", LaunchFilesTest)
