#!/usr/bin/env python3
"""Measures the graph: the lock's macro step for 1 and 3 locomotives with next to nothing to compute, beside a raw TCP
round trip in the same minute; the paper's whole run; memory of each node; time from launch to the first step."""

import csv
import os
import re
import statistics
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "test", "node"))
from graph import Graph, program, run_offline  # noqa: E402

ROUNDS = 5
MACRO_STEP_US = 2000.0


def real_time_factor(folder):
    with open(os.path.join(folder, "summary.csv")) as file:
        return next(float(row["value"]) for row in csv.DictReader(file) if row["quantity"] == "real_time_factor")


def tcp_round_trip_us():
    text = subprocess.run(
        [program("ltd_sim", "tcp_round_trip_benchmark"), "--benchmark_min_time=0.5"],
        check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, universal_newlines=True,
    ).stdout
    return float(re.search(r"real_time\s+([0-9.]+) us", text).group(1))


def lock_us(locomotives):
    """Wall time of one macro step with one wagon behind so many locomotives."""
    overrides = "train.groups.0.count=%d train.groups.1.count=1 run.end_time_s=20 run.end_location_km=9" % locomotives
    with Graph() as graph:
        graph.start_master()
        train = graph.start_train(overrides, record="false")
        for number in range(1, locomotives + 1):
            graph.start_loco(number)
        graph.wait_for_end(train)
        return MACRO_STEP_US / real_time_factor(graph.out)


def resident_mb(name):
    """Largest resident memory so far of the processes with this command name, in MB, in the order of their ids."""
    found = {}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/status" % pid) as file:
                text = file.read()
        except OSError:
            continue
        if text.startswith("Name:\t%s\n" % name):
            found[int(pid)] = int(re.search(r"VmHWM:\s+(\d+)", text).group(1)) / 1024.0
    return [found[pid] for pid in sorted(found)]


def paper_run():
    with Graph() as graph:
        begin = time.monotonic()
        launch = graph.launch("paper.launch", "record:=true")
        graph.wait_for_text(launch, "paper_1d starts")
        to_first_step_s = time.monotonic() - begin
        memory = {}
        while launch.poll() is None:
            now = {name: resident_mb(name) for name in ("ltd_node", "loco_node")}
            memory = now if now["ltd_node"] and now["loco_node"] else memory
            time.sleep(0.5)
        return to_first_step_s, memory, real_time_factor(graph.out)


def show(what, values, unit):
    print("%-52s %8.1f %8.1f %8.1f  %s" % (what, min(values), statistics.median(values), max(values), unit), flush=True)


def main():
    print("%-52s %8s %8s %8s" % ("", "min", "median", "max"))
    tcp, one, three = [], [], []
    for _ in range(ROUNDS):  # in turn, so that a busy moment of the machine meets all
        tcp.append(tcp_round_trip_us())
        one.append(lock_us(1))
        three.append(lock_us(3))
    show("raw TCP round trip", tcp, "us")
    show("macro step of the lock, 1 locomotive", one, "us")
    show("macro step of the lock, 3 locomotives", three, "us")
    with Graph() as graph:
        run_offline(graph.out, "")
        show("paper_1d offline with bag", [real_time_factor(graph.out)], "x real time")
    to_first_step_s, memory, factor = paper_run()
    show("paper_1d in the graph with bag", [factor], "x real time")
    show("from roslaunch to the first step", [to_first_step_s], "s")
    for name, values in memory.items():
        show("resident memory of " + name, values, "MB")


if __name__ == "__main__":
    main()
