#!/usr/bin/env python3
"""rviz with both panels under a screen of its own: the plugins load, the panels subscribe, a bag becomes curves."""

import csv
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
import xmlrpc.client

import rosbag
import rosunit

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), os.path.join(HERE, "..", "..", "..", "ltd_sim", "test", "node")]
from graph import DEADLINE_S, REPO, Graph, program  # noqa: E402
from screen import start_screen  # noqa: E402

SCENARIO = os.path.join(REPO, "config", "scenarios", "paper_2d.yaml")
LAYOUT = os.path.join(HERE, "panels.rviz")
OF_THE_LAYOUT = ["/train/state", "/train/energy", "/loco_1/adhesion", "/train/configuration", "/train/status", "/plots/export", "/chosen"]
PLOTS = ["traction", "energy", "adhesion", "couplers", "speed"]


class PanelsTest(unittest.TestCase):
    def setUp(self):
        self.graph = Graph().__enter__()
        self.addCleanup(shutil.rmtree, self.graph.folder, ignore_errors=True)
        self.addCleanup(self.graph.__exit__)
        environment = self.graph.environment
        environment.update(HOME=self.graph.folder, XDG_RUNTIME_DIR=self.graph.folder, LIBGL_ALWAYS_SOFTWARE="1")
        environment.pop("QT_QPA_PLATFORM", None)
        self.graph.start_master()
        self.master = xmlrpc.client.ServerProxy(environment["ROS_MASTER_URI"])
        environment["DISPLAY"] = start_screen(self.graph.start, "1600x900")

    def start_rviz(self):
        rviz = self.graph.start([program_of_rviz(), "-d", LAYOUT])
        self.addCleanup(self.graph.end, rviz, signal.SIGTERM)
        self.wait_for("the panels' subscriptions", lambda: set(OF_THE_LAYOUT) <= self.subscribed(), rviz)
        return rviz

    def wait_for(self, what, condition, rviz):
        deadline = time.monotonic() + DEADLINE_S
        while time.monotonic() < deadline:
            result = condition()
            if result:
                return result
            time.sleep(0.1)
        self.fail("waited in vain for %s: %s" % (what, self.graph.text(rviz)))

    def subscribed(self):
        """Topics that somebody subscribes to; only rviz runs here."""
        return {topic for topic, _ in self.master.getSystemState("/panels_test")[2][1]}

    def make_bag(self):
        out = os.path.join(self.graph.folder, "run")
        command = [program("ltd_sim", "ltd_offline"), SCENARIO, "--out", out, "--set", "run.end_time_s=30"]
        command += ["--set", "output.report_locations_km=[3.01]", "--set", "output.section_boundaries_km=[3.01]"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return os.path.join(out, "paper_2d.bag")

    def export(self, rviz):
        """Asks the panel for its plots until the newest of all files is whole; returns their folder."""
        folder = os.path.join(self.graph.folder, "plots")
        self.graph.call("rostopic", "pub", "-1", "/plots/export", "std_msgs/String", folder)
        last = os.path.join(folder, PLOTS[-1] + ".csv")
        self.wait_for("the export", lambda: os.path.exists(last) and os.path.getsize(last) > 0, rviz)
        return folder

    @staticmethod
    def table(folder, plot):
        with open(os.path.join(folder, plot + ".csv")) as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def test_a_bag_becomes_curves_in_rviz(self):
        bag = self.make_bag()
        rviz = self.start_rviz()
        play = ["--quiet", "--wait-for-subscribers", "-r", "10", bag, "--topics"] + OF_THE_LAYOUT[:4]
        self.graph.call("rosbag", "play", *play)
        folder = self.export(rviz)
        self.assertIsNone(rviz.poll(), self.graph.text(rviz))
        self.check_no_plugin_failed(rviz)
        self.check_curves(folder, bag)

    def test_a_locomotive_chosen_elsewhere_is_plotted(self):
        rviz = self.start_rviz()
        self.graph.call("rostopic", "pub", "-1", "/chosen", "std_msgs/Int32", "2")
        self.wait_for("locomotive 2", lambda: "/loco_2/adhesion" in self.subscribed(), rviz)
        self.assertNotIn("/loco_1/adhesion", self.subscribed())

    def check_no_plugin_failed(self, rviz):
        words = self.graph.text(rviz).lower()
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
