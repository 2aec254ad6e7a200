"""A train's graph for tests: a master on a free port of its own and the nodes as processes; ends what it started."""

import contextlib
import os
import signal
import socket
import subprocess
import tempfile
import time

import yaml

REPO = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", "..", ".."))
PAPER = os.path.join(REPO, "config", "scenarios", "paper_1d.yaml")
DEADLINE_S = 60.0


def program(package, name):
    """Path of a program in the devel or install spaces of this environment."""
    for space in os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep):
        path = os.path.join(space, "lib", package, name)
        if os.path.exists(path):
            return path
    raise RuntimeError("%s of %s is not built" % (name, package))


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def outcome_of(folder):
    with open(os.path.join(folder, "outcome.yaml")) as file:
        return yaml.safe_load(file)


def run_offline(out, overrides, scenario=PAPER):
    """Runs ltd_offline; returns its outcome."""
    command = [program("ltd_sim", "ltd_offline"), scenario, "--out", out]
    for override in overrides.split():
        command += ["--set", override]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return outcome_of(out)


class Graph:
    """Context manager. Nodes: start_train(), start_loco(i), or a whole launch file: launch()."""

    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="train_graph_")
        self.out = os.path.join(self.folder, "out")
        port = free_port()
        self.port = str(port)
        self.environment = dict(
            os.environ,
            ROS_MASTER_URI="http://127.0.0.1:%d" % port,
            ROS_IP="127.0.0.1",
            ROS_HOME=self.folder,
            ROS_LOG_DIR=os.path.join(self.folder, "log"),
        )
        self.environment.pop("ROS_NAMESPACE", None)
        self.processes = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            self.end(process, signal.SIGINT)

    def start(self, command, pass_fds=(), **environment):
        log = open(os.path.join(self.folder, "%d.log" % len(self.processes)), "w")
        process = subprocess.Popen(
            command,
            env=dict(self.environment, **environment),
            cwd=self.folder,
            stdout=log,
            stderr=subprocess.STDOUT,
            pass_fds=pass_fds,
        )
        process.log = log.name
        self.processes.append(process)
        return process

    def start_master(self):
        self.start(["/usr/bin/rosmaster", "--core", "-p", self.port])
        deadline = time.monotonic() + DEADLINE_S
        while time.monotonic() < deadline:
            with contextlib.closing(socket.socket()) as probe:
                if probe.connect_ex(("127.0.0.1", int(self.port))) == 0:
                    return
            time.sleep(0.02)
        raise RuntimeError("the master did not come up")

    def start_train(self, overrides="", scenario=PAPER, **parameters):
        parameters = dict(dict(scenario=scenario, out=self.out, record="true"), **parameters)
        arguments = ["_%s:=%s" % pair for pair in parameters.items()]
        if overrides:
            arguments.append("_set:=" + overrides)
        return self.start([program("ltd_sim", "ltd_node"), "__name:=ltd"] + arguments)

    def start_loco(self, number):
        return self.start(
            [program("loco_dynamics", "loco_node"), "__name:=loco", "__ns:=/loco_%d" % number, "_locomotive:=%d" % number]
        )

    def launch(self, file, *arguments):
        return self.start(
            ["/usr/bin/roslaunch", "-p", self.port, os.path.join(REPO, "launch", file), "out:=" + self.out] + list(arguments),
            PWD=self.folder,
        )

    def call(self, name, *arguments):
        """Runs one of ROS's own programs to its end; returns what it says."""
        command = ["/usr/bin/" + name] + list(arguments)
        return subprocess.run(
            command, check=True, env=self.environment, stdout=subprocess.PIPE, universal_newlines=True, timeout=DEADLINE_S
        ).stdout

    def text(self, process):
        with open(process.log) as file:
            return file.read()

    def wait_for_text(self, process, text):
        deadline = time.monotonic() + DEADLINE_S
        while time.monotonic() < deadline:
            if text in self.text(process):
                return
            time.sleep(0.02)
        raise AssertionError("no '%s' in:\n%s" % (text, self.text(process)))

    def wait_for_end(self, process, seconds=DEADLINE_S):
        try:
            return process.wait(seconds)
        except subprocess.TimeoutExpired:
            raise AssertionError("still running after %s s:\n%s" % (seconds, self.text(process)))

    @staticmethod
    def end(process, number):
        if process.poll() is None:
            process.send_signal(number)
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
