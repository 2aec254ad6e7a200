#!/usr/bin/env python3
"""Whole runs through the graph: the same bits as offline, faults by name, good endings and bags."""

import math
import os
import signal
import sys
import time
import unittest

import rosbag
import rosunit

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from graph import PAPER, REPO, Graph, outcome_of, program, run_offline  # noqa: E402

WET_STRETCH = os.path.join(REPO, "config", "scenarios", "wet_stretch.yaml")
EXTERNAL_DRIVER = os.path.join(REPO, "config", "scenarios", "external_driver.yaml")
PAPER_3D = os.path.join(REPO, "config", "scenarios", "paper_3d.yaml")
SHORT = "run.end_time_s=8"  # 4000 steps: all locomotives pull, the slack runs out


def payload(message):
    """A message without what differs between sessions: ids and sequence numbers."""
    if hasattr(message, "header"):
        message.header.seq = 0
    if hasattr(message, "id"):
        message.id.run_id = message.id.epoch = message.id.incarnation = 0
    return message


def bag_payloads(path):
    with rosbag.Bag(path) as bag:
        return [
            (topic, stamp.to_nsec(), payload(message))
            for topic, message, stamp in bag.read_messages()
            if topic != "/train/configuration"
        ]


class GraphTest(unittest.TestCase):
    def setUp(self):
        self.graph = Graph().__enter__()
        self.addCleanup(self.graph.__exit__)

    def offline(self, overrides):
        return run_offline(os.path.join(self.graph.folder, "offline"), overrides)

    def start_all(self, overrides, order=(1, 2, 3), **parameters):
        self.graph.start_master()
        train = self.graph.start_train(overrides, **parameters)
        return train, {i: self.graph.start_loco(i) for i in order}

    def test_the_papers_launch_gives_the_bits_of_the_offline_run_over_the_whole_run(self):
        launch = self.graph.launch("paper.launch", "model:=1d", "record:=true")
        self.graph.wait_for_end(launch, 600)
        outcome = outcome_of(self.graph.out)
        self.assertEqual(outcome["outcome"], "finished", outcome)
        self.assertEqual(outcome, self.offline("output.record_exchange=false"))

    def test_locomotives_started_in_another_order_give_the_same_bits_and_the_same_bag(self):
        overrides = SHORT + " output.record_exchange=true"
        train, _ = self.start_all(overrides, order=(3, 1, 2))
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))
        self.assertEqual(outcome_of(self.graph.out), self.offline(overrides))
        graph_bag = bag_payloads(os.path.join(self.graph.out, "paper_1d.bag"))
        offline_bag = bag_payloads(os.path.join(self.graph.folder, "offline", "paper_1d.bag"))
        self.assertEqual(len(graph_bag), 2 * 401 + 80 + 6 * 4000)
        self.assertEqual(graph_bag, offline_bag)

    def test_locomotives_with_contacts_give_the_same_bits_and_tell_the_same_of_their_adhesion(self):
        overrides = "run.start_location_km=3.36 run.start_speed_kmph=27 run.end_time_s=5"
        overrides += " output.report_locations_km=[3.38] output.section_boundaries_km=[3.37]"
        self.graph.start_master()
        train = self.graph.start_train(overrides, scenario=WET_STRETCH)
        for i in (1, 2, 3):
            self.graph.start_loco(i)
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))
        offline = os.path.join(self.graph.folder, "offline")
        self.assertEqual(outcome_of(self.graph.out), run_offline(offline, overrides, WET_STRETCH))
        graph_bag = bag_payloads(os.path.join(self.graph.out, "wet_stretch.bag"))
        self.assertEqual(graph_bag, bag_payloads(os.path.join(offline, "wet_stretch.bag")))
        leading = [message for topic, _, message in graph_bag if topic == "/loco_1/adhesion"]
        self.assertEqual(len(leading), 250)
        self.assertEqual({round(axle.static_friction, 3) for axle in leading[-1].axles}, {0.2})
        self.assertEqual({round(axle.static_friction, 3) for axle in leading[0].axles}, {0.35})
        self.check_frames([message for topic, _, message in graph_bag if topic == "/tf"][-1], leading[-1].location)

    def test_3d_locomotives_give_the_same_bits_and_tell_the_same_of_their_contacts(self):
        overrides = "run.start_location_km=3.4 run.start_speed_kmph=25 run.end_time_s=1"
        overrides += " output.report_locations_km=[3.405] output.section_boundaries_km=[3.405]"
        self.graph.start_master()
        train = self.graph.start_train(overrides, scenario=PAPER_3D)
        for i in (1, 2, 3):
            self.graph.start_loco(i)
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))
        offline = os.path.join(self.graph.folder, "offline")
        self.assertEqual(outcome_of(self.graph.out), run_offline(offline, overrides, PAPER_3D))
        graph_bag = bag_payloads(os.path.join(self.graph.out, "paper_3d.bag"))
        self.assertEqual(graph_bag, bag_payloads(os.path.join(offline, "paper_3d.bag")))
        last = [message for topic, _, message in graph_bag if topic == "/loco_1/adhesion"][-1]
        self.assertGreaterEqual(len(last.contacts), 12)
        weight = 134e3 * 9.81
        self.assertAlmostEqual(sum(axle.normal_force for axle in last.axles) / weight, 1.0, delta=0.05)

    def check_frames(self, message, location):
        """All bodies of three locomotives, where they belong on the paper's line, which begins at chainage 0."""
        frames = {transform.child_frame_id: transform for transform in message.transforms}
        self.assertEqual(len(frames), 3 * 10 + 1)
        base, train = frames["loco_1/base_link"], frames["train"]
        self.assertEqual((train.header, train.transform.translation), (base.header, base.transform.translation))
        self.assertEqual(train.transform.rotation.w, 1.0)
        self.assertEqual(base.header.frame_id, "map")
        steps = [3300 + (i + 0.5) * (location - 3300) / 10000 for i in range(10000)]
        headings = [min(s - 3300, 50) ** 2 / (2 * 50 * 300) + max(s - 3350, 0) / 300 for s in steps]
        ahead = sum(math.cos(heading) for heading in headings) * (location - 3300) / 10000
        left = sum(math.sin(heading) for heading in headings) * (location - 3300) / 10000
        self.assertAlmostEqual(base.transform.translation.x, 3300 + ahead, delta=1e-3)
        self.assertAlmostEqual(base.transform.translation.y, left, delta=1e-3)
        wheelset = frames["loco_1/wheelset_1"]
        self.assertEqual(wheelset.header.frame_id, "loco_1/base_link")
        self.assertAlmostEqual(wheelset.transform.translation.x, 6.645 + 1.85, delta=0.01)
        self.assertAlmostEqual(wheelset.transform.translation.z, 0.5335, delta=0.001)

    def start_external(self, overrides, **parameters):
        self.graph.start_master()
        train = self.graph.start_train(overrides, scenario=EXTERNAL_DRIVER, **parameters)
        for i in (1, 2, 3):
            self.graph.start_loco(i)
        return train

    def test_a_driver_in_another_program_gives_the_bits_of_the_same_commands_from_a_file(self):
        overrides = "run.end_time_s=25 output.record_exchange=true"
        train = self.start_external(overrides)
        notches = "[[0, 1], [10, 2], [20, 3], [30, 4], [40, 5], [50, 6], [60, 7], [70, 8]]"
        self.graph.start([program("ltd_sim", "example_driver"), "_notches:=" + notches])
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))
        offline = os.path.join(self.graph.folder, "offline")
        from_file = overrides + " driver_file=" + os.path.join(REPO, "config", "drivers", "paper_notches.yaml")
        self.assertEqual(outcome_of(self.graph.out), run_offline(offline, from_file, EXTERNAL_DRIVER))
        graph_bag = bag_payloads(os.path.join(self.graph.out, "external_driver.bag"))
        self.assertEqual(graph_bag, bag_payloads(os.path.join(offline, "external_driver.bag")))

    def test_a_driver_who_falls_silent_is_named_and_the_train_comes_to_rest(self):
        train = self.start_external("driver.answer_deadline_s=2 run.end_at_standstill_s=1", hold="true")
        driver = self.graph.start([program("ltd_sim", "example_driver"), "_notches:=[[0, 1], [4, 0]]"])
        self.graph.wait_for_text(train, "held at")
        self.call("RUN_UNTIL_TIME", 2.5)
        self.graph.wait_for_text(train, "2.500 s, step 1250")  # he has answered, so his own deadline holds
        driver.send_signal(signal.SIGKILL)
        self.call("RUN", 0)
        self.graph.wait_for_text(train, "the driver has not answered step 1500")
        self.assertEqual(self.graph.wait_for_end(train, 300), 1, self.graph.text(train))
        outcome = outcome_of(self.graph.out)
        self.assertEqual(outcome["outcome"], "failed")
        self.assertRegex(outcome["reason"], r"driver: no answer within 2 s to the question of 3\.000 s .* stands at ")
        self.assertRegex(outcome["notes"][-1], "driver: no answer within 2 s")

    def test_an_answer_that_cannot_be_obeyed_counts_as_none(self):
        train = self.start_external("driver.answer_deadline_s=1 run.end_time_s=60")
        self.graph.start([program("ltd_sim", "example_driver"), "_notches:=[[0, 1], [2, 9]]"])
        self.graph.wait_for_text(train, "the driver's answer to step 1000 was refused: notch = 9: must be 0 to 8")
        self.assertEqual(self.graph.wait_for_end(train), 1, self.graph.text(train))  # braked to a stand: he is silent
        outcome = outcome_of(self.graph.out)
        self.assertRegex(outcome["reason"], r"no answer within 1 s to the question of 2\.000 s")
        self.assertIn("driver: answer to the question of 2.000 s refused: notch = 9: must be 0 to 8", outcome["notes"])

    def test_a_first_answer_that_is_refused_leaves_the_first_deadline_as_it_is(self):
        train = self.start_external("driver.answer_deadline_s=1 run.end_time_s=4")
        self.graph.start([program("ltd_sim", "example_driver"), "_notches:=[[0, 9]]"])
        self.graph.wait_for_text(train, "the driver's answer to step 0 was refused: notch = 9: must be 0 to 8")
        time.sleep(1.5)  # longer than the deadline of an answer after the first
        self.graph.start([program("ltd_sim", "example_driver"), "_notches:=[[0, 1]]"])  # of the same name: takes his place
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))
        self.assertEqual(outcome_of(self.graph.out)["outcome"], "finished")

    def test_a_locomotive_killed_in_the_run_and_started_again_leaves_the_bits_alone(self):
        train, locos = self.start_all(SHORT, hold="true")
        for i in (1, 2, 3):
            self.graph.wait_for_text(locos[i], "joined as incarnation")
        self.call("RUN_UNTIL_TIME", 3.0)
        locos[2].send_signal(signal.SIGKILL)
        self.call("RUN", 0)
        self.graph.wait_for_text(train, "loco_2 has")  # "... not answered" or "... left": named after a second
        self.graph.start_loco(2)
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))
        self.assertEqual(outcome_of(self.graph.out), self.offline(SHORT))

    def test_a_missing_locomotive_is_named_and_fails_the_run_after_its_deadline(self):
        train, _ = self.start_all(SHORT + " lock.join_deadline_s=3", order=(1, 2))
        self.graph.wait_for_text(train, "loco_3 has not joined")
        self.assertEqual(self.graph.wait_for_end(train), 1)
        outcome = outcome_of(self.graph.out)
        self.assertEqual(outcome["outcome"], "failed")
        self.assertEqual(outcome["reason"], "loco_3 has not joined within 3.0 s")

    def test_a_late_locomotive_is_waited_for(self):
        train, _ = self.start_all(SHORT, order=(1, 2))
        self.graph.wait_for_text(train, "loco_3 has not joined")
        self.graph.start_loco(3)
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))
        self.assertEqual(outcome_of(self.graph.out), self.offline(SHORT))

    def test_a_locomotive_that_does_not_answer_fails_the_run_after_its_deadline(self):
        train, locos = self.start_all("lock.answer_deadline_s=3", hold="true")
        for i in (1, 2, 3):
            self.graph.wait_for_text(locos[i], "joined as incarnation")
        self.call("STEP", 10)
        locos[2].send_signal(signal.SIGSTOP)  # not the first: what comes before it has answered, and is of no state
        self.addCleanup(locos[2].send_signal, signal.SIGCONT)
        self.call("RUN", 0)
        self.assertEqual(self.graph.wait_for_end(train), 1)
        self.assertRegex(outcome_of(self.graph.out)["reason"], "loco_2 has not answered step 10 .*within 3.0 s")

    def test_a_fourth_locomotive_is_refused_with_the_reason_and_does_not_disturb(self):
        train, _ = self.start_all(SHORT, order=(1, 2, 3), hold="true")
        stranger = self.graph.start_loco(4)
        self.graph.wait_for_text(stranger, "there is no loco_4 in this train, it has 3 locomotives")
        self.call("RUN", 0)
        self.assertEqual(self.graph.wait_for_end(train), 0, self.graph.text(train))

    def test_an_interrupt_stops_the_run_in_good_order_and_the_bag_can_be_read(self):
        train, locos = self.start_all("output.record_exchange=true", hold="true")
        for i in (1, 2, 3):
            self.graph.wait_for_text(locos[i], "joined as incarnation")
        self.call("RUN_UNTIL_TIME", 1.0)
        train.send_signal(signal.SIGINT)
        self.assertEqual(self.graph.wait_for_end(train), 3)
        self.assertEqual(outcome_of(self.graph.out)["outcome"], "stopped")
        self.assertEqual(len(bag_payloads(os.path.join(self.graph.out, "paper_1d.bag"))), 2 * 51 + 10 + 6 * 500)

    def test_stop_through_the_service_stops_the_run_in_good_order(self):
        train, _ = self.start_all(SHORT, hold="true")
        self.call("STOP", 0)
        self.assertEqual(self.graph.wait_for_end(train), 3)
        self.assertEqual(outcome_of(self.graph.out)["reason"], "stopped through /train/step_lock")

    def test_a_faulty_scenario_ends_the_launch_with_all_problems(self):
        bad = os.path.join(self.graph.folder, "bad.yaml")
        with open(PAPER) as file:
            text = file.read().replace("../", os.path.join(REPO, "config") + "/")
        with open(bad, "w") as file:
            file.write(text.replace("macro_step_s", "makro_step_s").replace("start_speed_kmph: 5.0", "start_speed_kmph: -5"))
        launch = self.graph.launch("scenario.launch", "scenario:=" + bad)
        self.graph.wait_for_end(launch)
        for said in (self.graph.text(launch), outcome_of(self.graph.out)["reason"]):
            self.assertIn("bad.yaml: steps.macro_step_s: is missing", said)
            self.assertIn("did you mean 'macro_step_s'", said)
            self.assertIn("bad.yaml: run.start_speed_kmph = -5", said)

    def test_a_wrong_number_of_locomotives_in_the_launch_is_refused_with_the_right_one(self):
        launch = self.graph.launch("scenario.launch", "scenario:=" + PAPER, "locomotives:=2")
        self.graph.wait_for_end(launch)
        self.assertIn("add locomotives:=3", outcome_of(self.graph.out)["reason"])

    def call(self, command, value):
        """Calls /train/step_lock and waits until it is done, as far as it ends in HELD."""
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "call_step_lock.py")
        self.assertEqual(self.graph.wait_for_end(self.graph.start([sys.executable, script, command, str(value)])), 0)


if __name__ == "__main__":
    rosunit.unitrun("ltd_sim", "graph_test", GraphTest)
