#!/usr/bin/env python3
"""The launch files: every argument explains itself, a scenario goes by its name, one that is not there is answered."""

import os
import re
import signal
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import rosunit

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from graph import REPO, Graph, outcome_of  # noqa: E402

LAUNCH = os.path.join(REPO, "launch")
SCENARIOS = sorted(os.path.splitext(name)[0] for name in os.listdir(os.path.join(REPO, "config", "scenarios")))
FILES = sorted(name for name in os.listdir(LAUNCH) if name.endswith(".launch"))


def arguments_of(file):
    return ElementTree.parse(os.path.join(LAUNCH, file)).getroot().findall("arg")


class LaunchTest(unittest.TestCase):
    def setUp(self):
        self.graph = Graph().__enter__()
        self.addCleanup(self.graph.__exit__)

    def test_roslaunch_tells_what_each_argument_of_each_file_is_for(self):
        self.assertTrue(FILES)
        for file in FILES:
            command = ["/usr/bin/roslaunch", "--ros-args", os.path.join(LAUNCH, file)]
            told = subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
            for argument in arguments_of(file):
                name = argument.get("name")
                self.assertRegex(told, r"(?m)^ +%s( \(default .*\))?: (?!undocumented)\S" % re.escape(name), file)

    def test_roslaunch_finds_the_files_by_the_name_of_the_package(self):
        for file in FILES:
            command = ["/usr/bin/roslaunch", "ltd_sim", file, "--files", "scenario:=paper_1d", "locomotives:=3"]
            found = subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout.split()
            self.assertTrue(any(os.path.samefile(f, os.path.join(LAUNCH, file)) for f in found), found)

    def test_an_argument_means_the_same_in_every_file(self):
        known = {}
        for file in ("paper.launch", "scenario.launch"):
            for argument in arguments_of(file):
                known.setdefault(argument.get("name"), set()).add(argument.get("doc"))
        self.assertEqual({name: docs for name, docs in known.items() if len(docs) > 1}, {})

    def outcome_of_launch(self, *arguments):
        launch = self.graph.launch(*arguments)
        self.graph.wait_for_end(launch)
        return outcome_of(self.graph.out)

    def check_list(self, outcome, name):
        self.assertEqual(outcome["outcome"], "refused")
        self.assertIn("scenario %s does not exist, did you mean " % name, outcome["reason"])
        listed = outcome["reason"].rpartition("there are: ")[2].split(", ")
        self.assertEqual(sorted(listed), sorted(SCENARIOS))
        return outcome

    def test_a_model_that_does_not_exist_is_answered_with_the_scenarios_that_do(self):
        self.check_list(self.outcome_of_launch("paper.launch", "model:=4d"), "paper_4d")

    def test_a_name_that_does_not_exist_is_answered_with_the_scenarios_that_do(self):
        outcome = self.check_list(self.outcome_of_launch("scenario.launch", "scenario:=wet_strech"), "wet_strech")
        self.assertIn("config/scenarios/wet_stretch.yaml?", outcome["reason"])

    def test_a_scenario_goes_by_its_name(self):
        outcome = self.outcome_of_launch("scenario.launch", "scenario:=paper_1d", "record:=false", "set:=run.end_time_s=1")
        self.assertEqual(outcome["outcome"], "finished", outcome)

    def test_a_run_that_is_kept_can_be_looked_at_until_it_is_interrupted(self):
        launch = self.graph.launch(
            "scenario.launch", "scenario:=paper_1d", "record:=false", "set:=run.end_time_s=1", "keep:=true"
        )
        self.graph.wait_for_text(launch, "stays to be looked at until Ctrl-C")
        self.assertEqual(outcome_of(self.graph.out)["outcome"], "finished")
        state = self.graph.call("rostopic", "echo", "-n", "1", "/train/state/time")  # latched: it has come before
        self.assertEqual(state.split()[0], "1.0")
        answer = self.graph.call("rosservice", "call", "/train/step_lock", "RUN", "0")
        self.assertIn("the run has ended: reached the end time 1 s", answer)
        self.assertIsNone(launch.poll())
        self.graph.end(launch, signal.SIGINT)
        self.assertEqual(launch.returncode, 0)

    def test_without_rviz_nothing_is_kept(self):
        for file, arguments in (("paper.launch", []), ("scenario.launch", ["scenario:=paper_1d"])):
            for rviz in ("false", "true"):
                dump = self.graph.call("roslaunch", "--dump-params", os.path.join(LAUNCH, file), "rviz:=" + rviz, *arguments)
                self.assertIn("/ltd/keep: " + rviz, dump)

    def test_a_relative_file_counts_from_where_roslaunch_was_called(self):
        outcome = self.outcome_of_launch("scenario.launch", "scenario:=mine/run.yaml")
        self.assertIn("mine/run.yaml: scenario run does not exist; ", outcome["reason"])


if __name__ == "__main__":
    rosunit.unitrun("ltd_sim", "launch_test", LaunchTest)
