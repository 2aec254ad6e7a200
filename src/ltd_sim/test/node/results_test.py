#!/usr/bin/env python3
"""What a run leaves fits standard tools, and docs/topics.md and docs/files.md name all of it."""

import csv
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rosunit

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from graph import REPO, outcome_of, run_offline  # noqa: E402

TEXT_TOPICS = ("/train/configuration",)  # its resolved scenario has many lines: one message, no table


def page(name):
    with open(os.path.join(REPO, "docs", name)) as file:
        return file.read()


def named_in(text):
    """Every `code` of a page."""
    return set(re.findall(r"`([^`\n]+)`", text))


def table_of(bag, topic):
    """What rostopic makes of a topic, as rows of cells."""
    command = ["/usr/bin/rostopic", "echo", "-b", bag, "-p", topic]
    text = subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    return list(csv.reader(io.StringIO(text)))


class ResultsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="results_test_")
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        exchange = "output.record_exchange=true run.end_time_s=1"
        cls.paper_2d = cls.run_scenario("paper_2d", exchange)
        # in the curve, where the number of a wheel's contacts changes
        cls.paper_3d = cls.run_scenario(
            "paper_3d",
            "run.end_time_s=2.5 run.start_location_km=3.28 run.start_speed_kmph=50"
            " output.report_locations_km=[3.3] output.section_boundaries_km=[3.28,3.3]",
        )
        cls.supplied = cls.run_scenario(
            "mine_to_port_1d",
            "run.end_time_s=2 run.start_speed_kmph=20 output.report_locations_km=[2.505]"
            " output.section_boundaries_km=[2.501,2.505]",
        )

    @classmethod
    def run_scenario(cls, name, overrides):
        """Path of the bag of a short run."""
        out = os.path.join(cls.folder, name)
        run_offline(out, overrides, os.path.join(REPO, "config", "scenarios", name + ".yaml"))
        return os.path.join(out, name + ".bag")

    def topics(self, bag):
        with rosbag.Bag(bag) as opened:
            return sorted(opened.get_type_and_topic_info().topics)

    def check_table(self, rows):
        self.assertGreater(len(rows), 10)
        self.assertEqual(rows[0][0], "%time")
        self.assertEqual({len(row) for row in rows}, {len(rows[0])}, "ragged")
        times = [int(row[0]) for row in rows[1:]]
        self.assertTrue(all(a < b for a, b in zip(times, times[1:])), "time does not rise")
        self.assertNotIn("", rows[0])

    def test_rostopic_makes_a_table_of_every_topic_of_a_bag(self):
        topics = self.topics(self.paper_2d)
        self.assertEqual(len(topics), 13)
        for topic in topics:
            if topic not in TEXT_TOPICS:
                self.check_table(table_of(self.paper_2d, topic))

    def test_a_3d_locomotives_axles_make_a_table_though_its_contacts_come_and_go(self):
        self.check_table(table_of(self.paper_3d, "/loco_1/adhesion/axles[0]"))
        self.assertGreater(len({len(row) for row in table_of(self.paper_3d, "/loco_1/adhesion")}), 1)

    def test_every_topic_of_a_bag_has_its_row_in_the_page(self):
        known = named_in(page("topics.md"))
        self.assertEqual({re.sub(r"loco_\d+", "loco_i", topic) for topic in self.topics(self.paper_2d)} - known, set())

    def test_every_column_and_quantity_of_the_files_has_its_place_in_the_page(self):
        known = named_in(page("files.md"))
        folder = os.path.dirname(self.supplied)
        for name in sorted(os.listdir(folder)):
            if not name.endswith(".bag"):
                self.assertIn(name, known)
            if name.endswith(".csv"):
                with open(os.path.join(folder, name)) as file:
                    rows = list(csv.reader(file))
                self.assertEqual(set(rows[0]) - known, set(), name)
                if name == "summary.csv":
                    self.assertGreater(len(rows), 30)
                    self.assertEqual({row[2] for row in rows[1:]} - known, set())
        self.assertEqual(set(outcome_of(folder)) - known, set())


if __name__ == "__main__":
    rosunit.unitrun("ltd_sim", "results_test", ResultsTest)
