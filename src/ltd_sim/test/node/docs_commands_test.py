#!/usr/bin/env python3
"""Every command of README.md and docs/ works as it stands, or by what scripts/docs_commands.py names instead of it."""

import contextlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import rosunit

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from graph import REPO, Graph, outcome_of, program, run_offline  # noqa: E402

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(REPO, "scripts"))
import docs_commands  # noqa: E402

LIMIT_S = 60  # of one command, on a machine that is busy


def launch_arguments(file):
    return {argument.get("name") for argument in ElementTree.parse(file).getroot().findall("arg")}


class DocsCommandsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A folder that looks like the checkout, with the examples of the pages and short runs of the paper's case."""
        cls.folder = tempfile.mkdtemp(prefix="docs_commands_")
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for name in ("config", "launch", "scripts", "src", "without_ros"):
            os.symlink(os.path.join(REPO, name), os.path.join(cls.folder, name))
        for page in docs_commands.pages():
            for path, content in docs_commands.files_of_page(page.read_text()).items():
                cls.write(path, content)
        for out, name in (("offline", "paper_1d"), ("paper_1d", "paper_1d"), ("paper_2d", "paper_2d"), ("paper_3d", "paper_3d")):
            scenario = os.path.join(REPO, "config", "scenarios", name + ".yaml")
            run_offline(os.path.join(cls.folder, "results", out), "run.end_time_s=0.5", scenario)
        offline = os.path.dirname(program("ltd_sim", "ltd_offline"))
        cls.environment = dict(os.environ, PATH=offline + os.pathsep + os.environ["PATH"], MPLBACKEND="Agg")

    @classmethod
    def write(cls, path, content):
        path = os.path.join(cls.folder, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(content)

    def commands(self, chosen):
        """Of all pages, each once."""
        known = {}
        for command in docs_commands.all_commands():
            if chosen(command):
                known.setdefault(command.text, command)
        self.assertTrue(known)
        return known.values()

    @contextlib.contextmanager
    def told_with(self, command):
        """Goes on after a failure, which is told at the end. (rosunit's XML does not show those of subTest.)"""
        try:
            yield
        except AssertionError as failure:
            self.failed.append("%s:%d: %s\n%s" % (command.page, command.line, command.text, failure))

    def setUp(self):
        self.failed = []
        self.addCleanup(lambda: self.assertFalse(self.failed, "\n\n".join(self.failed)))

    def run_command(self, text, environment=None):
        return subprocess.run(
            ["timeout", str(LIMIT_S), "bash", "-o", "pipefail", "-c", text],  # ends what the shell has started, too
            cwd=self.folder,
            env=environment or self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            universal_newlines=True,
        )

    def test_commands_that_need_no_train(self):
        live = (docs_commands.LIVE, docs_commands.BY_HAND)
        for command in self.commands(lambda c: not any(pattern.match(c.text) for pattern in live)):
            with self.told_with(command):
                text = docs_commands.instead(command.text)[0]
                if text.startswith("launch "):
                    self.check_launch(shlex.split(text)[1:])
                else:
                    self.check_run(command, text)

    def check_run(self, command, text):
        run = self.run_command(text)
        if command.printed is None:
            self.assertEqual(run.returncode, 0, "%s\n%s" % (text, run.stdout))
        elif text:
            self.assertEqual(run.stdout.strip(), "\n".join(command.printed).strip())

    def check_launch(self, words):
        """File, arguments and scenario of a launch exist. ANY: an argument of some launch file."""
        file, given = words[0], dict(word.split(":=", 1) for word in words[1:])
        folder = os.path.join(REPO, "launch")
        files = [os.path.join(folder, name) for name in os.listdir(folder)] if file == "ANY" else [file]
        if file != "ANY" and not file.startswith("launch/"):
            self.fail("%s: is no file of launch/" % file)
        known = set().union(*(launch_arguments(os.path.join(REPO, f)) for f in files))
        self.assertLessEqual(set(given), known, "arguments that no launch file has")
        if "model" in given:
            self.assertTrue(os.path.exists(os.path.join(REPO, "config", "scenarios", "paper_%s.yaml" % given["model"])))
        if file != "ANY":
            command = "roslaunch --dump-params " + " ".join(shlex.quote(word) for word in words)
            run = self.run_command(command.replace("rviz:=true", "rviz:=false"))
            self.assertEqual(run.returncode, 0, run.stdout)
            scenario = re.search(r"(?m)^/ltd/scenario: (.*)$", run.stdout)
            if scenario:
                self.assertTrue(os.path.exists(os.path.join(self.folder, scenario.group(1))), scenario.group(1))

    def test_commands_beside_a_running_train(self):
        def rank(command):  # a train that is stopped answers no more
            for number, word in enumerate(("STEP", "HOLD", "RUN_UNTIL", "rostopic", "PACE", "RUN", "STOP")):
                if word in command.text:
                    return number
            self.fail("%s: say here when it may come" % command.text)

        with Graph() as graph:
            graph.start_master()
            scenario = os.path.join(REPO, "config", "scenarios", "paper_2d.yaml")
            train = graph.start_train(scenario=scenario, hold="true")
            for i in (1, 2, 3):
                graph.wait_for_text(graph.start_loco(i), "joined as incarnation")
            graph.wait_for_text(train, "held")
            self.assertIn("accepted: True", self.run_command("rosservice call /train/step_lock PACE 1", graph.environment).stdout)
            for command in sorted(self.commands(lambda c: docs_commands.LIVE.match(c.text)), key=rank):
                with self.told_with(command):
                    run = self.run_command(command.text.replace("echo", "echo -n 1"), graph.environment)
                    self.assertEqual(run.returncode, 0, run.stdout)
                    if command.text.startswith("rosservice"):
                        self.assertIn("accepted: True", run.stdout)
                    if "STEP" in command.text:
                        self.check_names(graph)
            self.assertEqual(graph.wait_for_end(train), 3, graph.text(train))

    def check_names(self, graph):
        """docs/topics.md has all topics and services of the graph."""
        with open(os.path.join(REPO, "docs", "topics.md")) as file:
            known = set(re.findall(r"`([^`\n]+)`", file.read()))
        for command in ("rostopic list", "rosservice list"):
            names = self.run_command(command, graph.environment).stdout.split()
            ours = {re.sub(r"loco_\d+", "loco_i", n) for n in names if "rosout" not in n and not re.search("loggers?(_level)?$", n)}
            self.assertGreater(len(ours), 1)
            self.assertEqual(ours - known, set())

    def test_commands_that_make_a_graph_by_hand(self):
        with Graph() as graph:
            for command in self.commands(lambda c: docs_commands.BY_HAND.match(c.text)):
                text = command.text.replace("$PWD/results", graph.folder)
                text = text.replace("$PWD", REPO) + (" -p " + graph.port if text == "roscore" else "")
                if "ltd_node" in text:
                    text += " _set:=run.end_time_s=0.2"
                process = graph.start(["bash", "-c", "exec " + text])
                if "ltd_node" in text:
                    train = process
            self.assertEqual(graph.wait_for_end(train), 0, graph.text(train))
            self.assertEqual(outcome_of(os.path.join(graph.folder, "by_hand"))["outcome"], "finished")


if __name__ == "__main__":
    rosunit.unitrun("ltd_sim", "docs_commands_test", DocsCommandsTest)
