#!/usr/bin/env python3
"""rviz with both panels under a screen of its own: the plugins load, the panels subscribe, a bag becomes curves."""

import contextlib
import csv
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import xmlrpc.client

import rosbag
import rosunit

HERE = os.path.dirname(os.path.abspath(__file__))
REPO = os.path.abspath(os.path.join(HERE, "..", "..", "..", ".."))
SCENARIO = os.path.join(REPO, "config", "scenarios", "paper_2d.yaml")
LAYOUT = os.path.join(HERE, "panels.rviz")
DEADLINE_S = 60.0
OF_THE_LAYOUT = ["/train/state", "/train/energy", "/loco_1/adhesion", "/train/configuration", "/train/status", "/plots/export"]
PLOTS = ["traction", "energy", "adhesion", "couplers", "speed"]


def program(package, name):
    for space in os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep):
        path = os.path.join(space, "lib", package, name)
        if os.path.exists(path):
            return path
    raise RuntimeError("%s of %s is not built" % (name, package))


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class PanelsTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="train_panels_")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        port = free_port()
        self.environment = dict(
            os.environ,
            ROS_MASTER_URI="http://127.0.0.1:%d" % port,
            ROS_IP="127.0.0.1",
            ROS_HOME=self.folder,
            ROS_LOG_DIR=os.path.join(self.folder, "log"),
            HOME=self.folder,
            XDG_RUNTIME_DIR=self.folder,
            LIBGL_ALWAYS_SOFTWARE="1",
        )
        self.environment.pop("ROS_NAMESPACE", None)
        self.environment.pop("QT_QPA_PLATFORM", None)
        self.master = xmlrpc.client.ServerProxy(self.environment["ROS_MASTER_URI"])
        self.start("master", ["/usr/bin/env", "rosmaster", "--core", "-p", str(port)])
        self.wait_for("the master", self.master_is_up)
        self.environment["DISPLAY"] = self.start_screen()

    def text(self, name):
        with open(os.path.join(self.folder, name + ".log"), errors="replace") as log:
            return log.read()

    def start(self, name, command, **options):
        with open(os.path.join(self.folder, name + ".log"), "w") as log:
            process = subprocess.Popen(
                command, env=self.environment, cwd=self.folder, stdout=log, stderr=subprocess.STDOUT, **options
            )
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.send_signal(signal.SIGINT if "rviz" not in process.args[0] else signal.SIGTERM)
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def start_screen(self):
        """Xvfb chooses a number that is free and says which."""
        read_end, write_end = os.pipe()
        command = ["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1600x900x24", "-nolisten", "tcp"]
        self.start("screen", command, pass_fds=[write_end])
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()
        self.assertTrue(number, self.text("screen"))
        return ":" + number

    def wait_for(self, what, condition):
        deadline = time.monotonic() + DEADLINE_S
        while time.monotonic() < deadline:
            result = condition()
            if result:
                return result
            time.sleep(0.1)
        logs = {name: self.text(name) for name in ("rviz", "play") if os.path.exists(os.path.join(self.folder, name + ".log"))}
        self.fail("waited in vain for %s: %s" % (what, logs))

    def master_is_up(self):
        try:
            return self.master.getPid("/panels_test")[0] == 1
        except OSError:
            return False

    def subscribed(self):
        """Topics that somebody subscribes to; only rviz runs here."""
        return {topic for topic, _ in self.master.getSystemState("/panels_test")[2][1]}

    def make_bag(self):
        out = os.path.join(self.folder, "run")
        command = [program("ltd_sim", "ltd_offline"), SCENARIO, "--out", out, "--set", "run.end_time_s=30"]
        command += ["--set", "output.report_locations_km=[3.01]", "--set", "output.section_boundaries_km=[3.01]"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return os.path.join(out, "paper_2d.bag")

    def export(self):
        """Asks the panel for its plots until the newest of all files is whole; returns their folder."""
        folder = os.path.join(self.folder, "plots")
        command = ["/usr/bin/env", "rostopic", "pub", "-1", "/plots/export", "std_msgs/String", folder]
        subprocess.run(command, check=True, env=self.environment, stdout=subprocess.DEVNULL, timeout=DEADLINE_S)
        last = os.path.join(folder, PLOTS[-1] + ".csv")
        self.wait_for("the export", lambda: os.path.exists(last) and os.path.getsize(last) > 0)
        return folder

    @staticmethod
    def table(folder, plot):
        with open(os.path.join(folder, plot + ".csv")) as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def test_a_bag_becomes_curves_in_rviz(self):
        bag = self.make_bag()
        rviz = self.start("rviz", [program_of_rviz(), "-d", LAYOUT])
        self.wait_for("the panels' subscriptions", lambda: set(OF_THE_LAYOUT) <= self.subscribed())
        topics = OF_THE_LAYOUT[:4]
        play = ["/usr/bin/env", "rosbag", "play", "--quiet", "--wait-for-subscribers", "-r", "10", bag, "--topics", *topics]
        player = self.start("play", play)
        self.assertEqual(player.wait(DEADLINE_S), 0, self.text("play"))
        folder = self.export()
        self.assertIsNone(rviz.poll(), self.text("rviz"))
        self.check_no_plugin_failed()
        self.check_curves(folder, bag)

    def check_no_plugin_failed(self):
        words = self.text("rviz").lower()
        for trouble in ("failed to load", "pluginlib", "train_viz", "could not find library"):
            self.assertNotIn(trouble, words)

    def check_curves(self, folder, bag):
        with rosbag.Bag(bag) as file:
            *_, (_, last, _) = file.read_messages(topics=["/train/state"])
        for plot in PLOTS:
            self.assertGreater(os.path.getsize(os.path.join(folder, plot + ".png")), 8000, plot)
        traction = [row for row in self.table(folder, "traction") if row["curve"] == "locomotive 3"]
        self.assertGreater(len(traction), 1000)
        self.assertAlmostEqual(float(traction[-1]["Place [km]"]), 1e-3 * last.location, places=6)
        self.assertAlmostEqual(float(traction[-1]["Force [kN], + forward"]), 1e-3 * last.traction[2], places=4)
        forces = [float(row["Force [kN], draft +"]) for row in self.table(folder, "couplers") if row["curve"] == "now"]
        self.assertEqual(len(forces), 107)
        self.assertAlmostEqual(forces[0], 1e-3 * last.coupler_force[0], places=4)
        curves = {row["curve"] for row in self.table(folder, "adhesion")}
        self.assertIn("creep curve", curves)
        self.assertIn("axle 6", curves)
        self.assertGreater(len(self.table(folder, "energy")), 1000)


def program_of_rviz():
    """Debian's is on the PATH, Noetic's in the package's folder of programs, which is on it as well."""
    path = shutil.which("rviz")
    if path is None:
        raise RuntimeError("rviz is not installed")
    return path


if __name__ == "__main__":
    rosunit.unitrun("train_viz", "panels", PanelsTest, sysargs=sys.argv)
