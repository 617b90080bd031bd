#!/usr/bin/env python3
"""Loads each launch file of the suite as roslaunch does and looks at what it would start."""
import glob
import itertools
import os
import resource
import shutil
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree

import rosgraph
import roslaunch.config
import roslaunch.core
import roslaunch.xmlloader
import roslib.packages
import rosunit

PACKAGE = "sylph_bringup"
ROOT = roslib.packages.get_pkg_dir(PACKAGE)
LAB = os.path.join(ROOT, "launch", "lab_experiment.launch")
REPLAY = os.path.join(ROOT, "launch", "replay.launch")
USER_PATH = roslib.packages.find_node(PACKAGE, "user_path")[0]
DEADLINE_S = 30.0
SIMULATION = {"sylph_sim"}
ALWAYS = {
    "mocap_bridge",
    "sylph_adg_central",
    "sylph_separation_monitor",
    "sylph_planner",
    "sylph_markers",
    "sylph_mission",
}
AGREED = ["experiment", "seed", "planner", "weights", "speed", "lock_step", "run_folder"]


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


def value_of(config, parameter):
    return config.params[parameter].value


class LaunchFilesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        self.folder = os.path.join(os.path.realpath(folder.name), "a folder")
        os.mkdir(self.folder)
        os.chdir(self.folder)

    def write(self, name):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write("nothing reads this\n")
        return path

    def test_every_file_loads_and_its_nodes_exist(self):
        self.write("1")
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

    def test_each_switch_starts_its_nodes_among_all_others_and_alone(self):
        switches = {"sim": SIMULATION, "rviz": {"rviz"}, "record": {"record_run"}, "local_robots": {"start_robots"},
                    "exit_when_done": set()}  # fmt: skip
        for values in itertools.product([True, False], repeat=len(switches)):
            if 1 < sum(values) < len(switches) - 1:
                continue
            chosen = dict(zip(switches, values))
            with self.subTest(**chosen):
                config = load(LAB, **{name: str(value).lower() for name, value in chosen.items()})
                expected = ALWAYS.union(*(nodes for name, nodes in switches.items() if chosen[name]))
                self.assertEqual(expected, node_names(config))
                exits = value_of(config, "/sylph/sylph_mission/exit_when_done")
                self.assertEqual(chosen["exit_when_done"], exits)

    def test_no_display_or_recorder_ends_the_rest(self):
        for path in [LAB, REPLAY]:
            for node in load(path, bag=self.write("run.bag")).nodes:
                if node.name in ("rviz", "record_run", "sylph_markers"):
                    self.assertFalse(node.required, node.name)

    def test_no_lab_drives_without_its_separation_monitor(self):
        for sim in ("true", "false"):
            required = {node.name for node in load(LAB, sim=sim).nodes if node.required}
            self.assertIn("sylph_separation_monitor", required)

    def test_what_nodes_agree_on_is_said_once(self):
        config = load(LAB, experiment="lab_room", seed=7, planner="pibt", speed=2, run_folder="/run")
        said = [name for name in config.params if name.rsplit("/", 1)[-1] in AGREED]
        self.assertEqual(sorted("/sylph/" + name for name in AGREED), sorted(said))
        self.assertEqual(os.path.join(ROOT, "maps", "lab_room.yaml"), value_of(config, "/sylph/experiment"))
        self.assertEqual(7, value_of(config, "/sylph/seed"))
        self.assertEqual("pibt", value_of(config, "/sylph/planner"))
        self.assertEqual("/run", value_of(config, "/sylph/run_folder"))

    def test_what_concerns_one_node_reaches_its_parameters(self):
        arguments = {"align": "/sylph/sylph_adg_central/align",
                     "ignore_unseen_robots": "/sylph/sylph_planner/ignore_unseen_robots"}  # fmt: skip
        for argument, parameter in arguments.items():
            for value in (True, False):
                self.assertIs(value, value_of(load(LAB, **{argument: str(value).lower()}), parameter))

    def test_paths_count_from_where_the_user_stands(self):
        lab, weights = self.write("my lab.yaml"), self.write("w.safetensors")
        os.environ["HOME"] = self.folder
        for start in ("", "./", "~/", self.folder + "/"):
            config = load(LAB, experiment=start + "my lab.yaml", weights=start + "w.safetensors", run_folder=start + "r")
            self.assertEqual(lab, value_of(config, "/sylph/experiment"))
            self.assertEqual(weights, value_of(config, "/sylph/weights"))
            self.assertEqual(os.path.join(self.folder, "r"), value_of(config, "/sylph/run_folder"))

    def test_so_do_paths_of_configurations_and_of_what_is_written(self):
        for name in ("mocap.yaml", "sim.yaml"):
            with open(self.write(name), "w", encoding="utf-8") as stream:
                stream.write("mark: " + name)
        rviz, bag = self.write("my.rviz"), self.write("my.bag")
        os.environ["HOME"] = self.folder
        for start in ("", "./", "~/", self.folder + "/"):
            config = load(LAB, mocap_config=start + "mocap.yaml", sim_config=start + "sim.yaml", mission_status=start + "s")
            self.assertEqual("mocap.yaml", value_of(config, "/sylph/mocap_bridge/mark"))
            self.assertEqual("sim.yaml", value_of(config, "/sylph/sylph_sim/mark"))
            self.assertEqual(os.path.join(self.folder, "s"), value_of(config, "/sylph/mission_status"))
            replay = load(REPLAY, bag=start + "my.bag", rviz_config=start + "my.rviz")
            self.assertEqual(rviz, value_of(replay, "/replay/rviz/config"))
            self.assertEqual(bag, value_of(replay, "/replay/replay_run/bag"))
        for name in ("mocap_config", "sim_config", "weights", "experiment"):
            with self.assertRaises(roslaunch.core.RLException):
                load(LAB, **{name: "nowhere/f"})
        with self.assertRaises(roslaunch.core.RLException):
            load(LAB, mission_status="nowhere/f")
        with self.assertRaises(roslaunch.core.RLException):
            load(REPLAY, bag=bag, rviz_config="nowhere")

    def test_the_missions_exit_status_is_kept(self):
        status = os.path.join(self.folder, "the status")
        program = roslib.packages.find_node(PACKAGE, "keep_exit_status")[0]
        master = rosgraph.Master("launch_files_test")
        master.setParam("/status_file", status)
        master.setParam("/no_file", "")
        for command, expected in ((["sh", "-c", "exit 3"], 3), (["true"], 0), (["sh", "-c", "kill -9 $$"], 137)):
            self.assertEqual(expected, subprocess.run([program, "status_file"] + command, check=False).returncode)
            with open(status, encoding="utf-8") as stream:
                self.assertEqual(str(expected), stream.read().strip())
        for name in ("no_file", "not_set"):
            self.assertEqual(3, subprocess.run([program, name, "sh", "-c", "exit 3"], check=False).returncode)
        config = load(LAB, mission_status=status)
        self.assertEqual(status, value_of(config, "/sylph/mission_status"))
        mission = [node for node in config.nodes if node.name == "sylph_mission"]
        self.assertIn("keep_exit_status mission_status", mission[0].launch_prefix)

    def test_refuses_the_folder_of_a_run_that_is_over(self):
        folder = os.path.join(self.folder, "run")
        os.mkdir(folder)
        command = [USER_PATH, "folder", folder, "lab_maze"]
        self.assertEqual(0, subprocess.run(command, capture_output=True, check=False).returncode)
        for name, text in (("result.yaml", "success: true"), ("events.jsonl", '{"phase": "finished"}\n')):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                stream.write(text)
            result = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertEqual(2, result.returncode, name)
            self.assertIn("run folder {}: holds a run that is over".format(folder), result.stderr)
            with self.assertRaises(roslaunch.core.RLException):
                load(LAB, run_folder=folder)
        with open(os.path.join(folder, "events.jsonl"), "w", encoding="utf-8") as stream:
            stream.write('{"phase": "finished"}\n{"phase": "executing"}\n')
        self.assertEqual(0, subprocess.run(command, capture_output=True, check=False).returncode, "a run to resume")

    def assert_folder_refused(self, folder, reason, **how):
        """By user_path, and by roslaunch before any node starts. Paths count from the test's folder."""
        result = subprocess.run([USER_PATH, "folder", folder, "lab_room"], capture_output=True, text=True, check=False, **how)
        self.assertEqual((2, ""), (result.returncode, result.stdout))
        self.assertEqual("user_path: run folder {}: {}\n".format(os.path.abspath(folder), reason), result.stderr)
        if not how:
            with self.assertRaises(roslaunch.core.RLException):
                load(LAB, experiment="lab_room", run_folder=folder)

    def test_refuses_the_folder_of_an_unfinished_run_of_another_experiment(self):
        os.mkdir("run")
        shutil.copy(os.path.join(ROOT, "maps", "lab_maze.yaml"), "run/experiment.yaml")
        with open("run/events.jsonl", "w", encoding="utf-8") as stream:
            stream.write('{"phase": "executing"}\n')
        self.assertTrue(load(LAB, experiment="lab_maze", run_folder="run").nodes)
        self.assert_folder_refused("run", "holds a run of another experiment; name one that does not exist yet, or none")

    def test_refuses_the_folder_of_an_unfinished_run_on_another_map_or_of_another_seed(self):
        shutil.copytree(os.path.join(ROOT, "test", "fleets"), "fleets")
        os.makedirs("run")
        for copy, file in (("experiment.yaml", "pair.yaml"), ("map.yaml", "hall.yaml"), ("map.pgm", "hall.pgm")):
            shutil.copy(os.path.join("fleets", file), os.path.join("run", copy))
        for name, text in (("seed.txt", "0\n"), ("events.jsonl", '{"phase": "executing"}\n')):
            with open(os.path.join("run", name), "w", encoding="utf-8") as stream:
                stream.write(text)

        def refusal(seed=-1):
            command = [USER_PATH, "folder", "run", "fleets/pair.yaml", str(seed)]
            ran = subprocess.run(command, capture_output=True, text=True, check=False)
            return ran.stderr.partition(" holds a run ")[2].partition(";")[0]

        self.assertEqual(["", "", "of another seed"], [refusal(), refusal(0), refusal(7)])
        with self.assertRaises(roslaunch.core.RLException):
            load(LAB, experiment="fleets/pair.yaml", run_folder="run", seed=7)
        for file in ("hall.pgm", "hall.yaml"):
            with open(os.path.join("fleets", file), "r+", encoding="utf-8") as stream:
                text = stream.read()
                stream.write("# edited\n")
            self.assertEqual("on another map", refusal(), file)
            with open(os.path.join("fleets", file), "w", encoding="utf-8") as stream:
                stream.write(text)
        self.assertEqual("", refusal())

    def test_refuses_a_folder_whose_event_log_the_central_node_could_not_go_on_from(self):
        os.mkdir("run")
        executing = '{"phase": "executing"}\n'
        for log, reason in (
            (executing + "null\n" + executing, "that cannot go on: events.jsonl:2 is no event"),
            ('{"event": "mode"}\n', "that is over"),
            (executing + '{"phase": "refused"}\n', "that is over"),
        ):
            with open("run/events.jsonl", "w", encoding="utf-8") as stream:
                stream.write(log)
            self.assert_folder_refused("run", f"holds a run {reason}; name one that does not exist yet, or none")
        with open("run/events.jsonl", "w", encoding="utf-8") as stream:
            stream.write(executing + '{"phase": "fini')
        self.assertTrue(load(LAB, run_folder="run").nodes, "a line that was cut off")

    def test_refuses_a_folder_that_cannot_be_made_or_written(self):
        name_another = "; name one that can, with run_folder:=FOLDER"
        self.write("file")
        self.assert_folder_refused("file/run", "cannot be written: Not a directory" + name_another)
        os.makedirs("run/events.jsonl")
        self.assert_folder_refused("run", "cannot be written: Is a directory" + name_another)
        limit = (resource.RLIMIT_FSIZE, (1000, 1000))  # as good as a full disk
        self.assert_folder_refused("full/run", "cannot be written: File too large" + name_another,
                                   preexec_fn=lambda: resource.setrlimit(*limit))  # fmt: skip
        self.assertEqual(["file", "run"], sorted(os.listdir(".")), "nothing is left behind")
        os.environ["ROS_HOME"], home = "file", os.environ.get("ROS_HOME")
        try:
            with self.assertRaises(roslaunch.core.RLException):
                load(LAB)
        finally:
            os.environ["ROS_HOME"] = home or os.path.expanduser("~/.ros")

    def test_refuses_an_experiment_that_is_neither_file_nor_name(self):
        command = [USER_PATH, "experiment", "lab_mase"]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(2, result.returncode)
        self.assertEqual("user_path: no experiment 'lab_mase': give a file, or one of lab_maze, lab_random, lab_room\n",
                         result.stderr)  # fmt: skip
        with self.assertRaises(roslaunch.core.RLException):
            load(LAB, experiment="lab_mase")
        with self.assertRaises(roslaunch.core.RLException):
            load(LAB, weights="nowhere.safetensors")

    def test_a_fleet_has_all_its_names_in_its_namespace(self):
        bag = self.write("run.bag")
        for path in launch_files():
            arguments = {"bag": bag} if path.endswith("replay.launch") else {"robot": "cf1"}
            config = load(path, ns="lab", **arguments)
            self.assert_all_names_below("/lab/", config)
            os.environ["ROS_NAMESPACE"] = "lab"
            self.addCleanup(os.environ.pop, "ROS_NAMESPACE", None)
            there = load(path, **arguments)
            if path == REPLAY:
                self.assert_all_names_below("/lab/replay/", there)
            else:
                self.assertEqual(sorted(config.params), sorted(there.params))
            del os.environ["ROS_NAMESPACE"]

    def assert_all_names_below(self, namespace, config):
        self.assertTrue(config.nodes)
        for name in [node.namespace for node in config.nodes] + list(config.params):
            self.assertTrue(name.startswith(namespace), name)

    def test_a_replay_has_all_its_names_apart_from_a_labs(self):
        self.assert_all_names_below("/replay/", load(REPLAY, bag=self.write("run.bag")))

    def start_node(self, name, namespace, topic="said"):
        """A node that speaks on one topic and stays until it is killed."""
        program = f"from rospy import *; init_node('{name}'); _ = Publisher('{topic}', AnyMsg, queue_size=1); spin()"
        process = subprocess.Popen(["python3", "-c", program], env=dict(os.environ, ROS_NAMESPACE=namespace))
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + DEADLINE_S
        while f"/{namespace}/{topic}" not in [published for published, _ in rosgraph.Master("t").getSystemState()[0]]:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        return process

    def test_a_launch_leaves_alone_what_is_alive_in_its_namespace(self):
        master = rosgraph.Master("launch_files_test")
        master.setParam("/a/lab/sylph/experiment", "/the/live/lab.yaml")
        self.addCleanup(master.deleteParam, "/a")
        bag = self.write("run.bag")
        ways = ((["ns:=/a/lab"], {"ROS_NAMESPACE": "b"}), (["ns:=lab"], {"ROS_NAMESPACE": "/a/"}), (["ns:=lab", "__ns:=a"], {}))
        for kind, node, namespace in (("lab", "sylph_adg_central", "a/lab/sylph"), ("replay", "replay_run", "a/lab")):
            process = self.start_node(node, namespace)
            for path, (arguments, environment) in itertools.product([LAB, REPLAY], ways if kind == "lab" else ways[:1]):
                before = master.getParam("/")
                result = subprocess.run(["roslaunch", path, f"bag:={bag}", "rviz:=false", *arguments], text=True, check=False,
                                        capture_output=True, env=dict(os.environ, **environment), timeout=DEADLINE_S)  # fmt: skip
                self.assertNotEqual(0, result.returncode)
                self.assertIn(f"a {kind} is alive in the namespace /a/lab/ of this ROS master (node /{namespace}/{node})",
                              result.stderr)  # fmt: skip
                self.assertEqual(before, master.getParam("/"))
            self.assertTrue(load(REPLAY, bag=bag, ns="a").nodes, "there is room elsewhere")
            other_master = ["--nodes", REPLAY, f"bag:={bag}", "ns:=/a/lab"]
            for option in (["-p", "1"], ["--port=1"]):
                subprocess.run(["roslaunch", *option, *other_master], check=True, timeout=DEADLINE_S)
            process.kill()  # the master goes on naming it
            process.wait()
            for path in (LAB, REPLAY):
                self.assertTrue(load(path, bag=bag, ns="a/lab").nodes)

    def test_robots_may_wait_for_their_lab_but_hear_no_replay(self):
        self.start_node("sylph_robot", "c/cf1", "task_report")
        self.assertTrue(load(LAB, ns="c").nodes)
        with self.assertRaises(roslaunch.core.RLException):
            load(REPLAY, bag=self.write("run.bag"), ns="c")

    def test_a_robot_takes_the_labs_experiment_or_a_copy(self):
        robot = os.path.join(ROOT, "launch", "robot.launch")
        node = load(robot, robot="cf1").nodes[0]
        self.assertEqual(("/cf1/", "sylph_robot", True), (node.namespace, node.name, node.respawn))
        self.assertNotIn("/cf1/sylph_robot/experiment", load(robot, robot="cf1").params)
        copy = load(robot, robot="cf1", experiment="lab_room")
        self.assertEqual(os.path.join(ROOT, "maps", "lab_room.yaml"), value_of(copy, "/cf1/sylph_robot/experiment"))

    def test_real_robots_know_neither_speed_factor_nor_lock_step(self):
        simulated = load(LAB, speed=4)
        self.assertIs(True, value_of(simulated, "/sylph/lock_step"))
        self.assertIs(False, value_of(load(LAB, lock_step="false"), "/sylph/lock_step"))
        self.assertEqual(0.0, value_of(load(LAB, speed="max"), "/sylph/speed"))
        self.assertTrue(value_of(simulated, "/use_sim_time"))
        self.assertEqual(4.0, value_of(simulated, "/sylph/speed"))
        real = load(LAB, speed=4, sim="false")
        self.assertFalse(value_of(real, "/use_sim_time"))
        self.assertEqual(1.0, value_of(real, "/sylph/speed"))
        self.assertIs(False, value_of(real, "/sylph/lock_step"))

    def test_simulated_cameras_and_bridge_speak_on_the_same_ports(self):
        config = load(LAB, natnet_port=2000)
        self.assertEqual(2000, value_of(config, "/sylph/sylph_sim/natnet/command_port"))
        self.assertEqual(2001, value_of(config, "/sylph/sylph_sim/natnet/data_port"))
        self.assertEqual(2000, value_of(config, "/sylph/mocap_bridge/command_port"))
        self.assertEqual(2001, value_of(config, "/sylph/mocap_bridge/data_port"))


if __name__ == "__main__":
    rosunit.unitrun(PACKAGE, "launch_files", LaunchFilesTest)
