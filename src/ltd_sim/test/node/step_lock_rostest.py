#!/usr/bin/env python3
"""The lock through the graph: join, hold, step, run until a place, and a locomotive that is killed and comes back."""

import os
import signal
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
from tf2_msgs.msg import TFMessage
from train_msgs.msg import TrainEnergy, TrainState, TrainStatus
from train_msgs.srv import StepLock

DEADLINE_S = 30.0  # of wall time, for a machine that is busy


class StepLockTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("step_lock_rostest")
        cls.news = threading.Condition()
        cls.status = None
        cls.states = []
        cls.energies = []
        cls.subscribers = [
            rospy.Subscriber("/train/status", TrainStatus, cls.on_status),
            rospy.Subscriber("/train/state", TrainState, cls.states.append),
            rospy.Subscriber("/train/energy", TrainEnergy, cls.energies.append),
        ]
        rospy.wait_for_service("/train/step_lock", DEADLINE_S)
        cls.step_lock = staticmethod(rospy.ServiceProxy("/train/step_lock", StepLock))

    @classmethod
    def on_status(cls, status):
        with cls.news:
            cls.status = status
            cls.news.notify_all()

    def wait_until(self, what, condition):
        """Waits for a status that meets `condition`; fails by name after the deadline."""
        with self.news:
            met = self.news.wait_for(lambda: self.status is not None and condition(self.status), DEADLINE_S)
            self.assertTrue(met, "%s; last status:\n%s" % (what, self.status))
            return self.status

    def wait_held_at(self, what, condition):
        return self.wait_until(what, lambda s: s.phase == TrainStatus.HELD and condition(s))

    def check_shown(self, status):
        """Who comes while the train is held sees it where it stands: state and frames are those of the last step."""
        self.wait_for_state(status.step)
        self.assertAlmostEqual(self.states[-1].location, status.location, places=9)
        frames = rospy.wait_for_message("/tf", TFMessage, DEADLINE_S).transforms  # nothing but this listens to it
        self.assertEqual({frame.header.stamp for frame in frames}, {status.header.stamp})
        leading = [frame for frame in frames if frame.child_frame_id == "loco_1/base_link"]
        self.assertAlmostEqual(leading[0].transform.translation.x, status.location, places=6)  # the line is straight here

    def wait_for_state(self, step):
        deadline = time.monotonic() + DEADLINE_S
        while not self.states or self.states[-1].step != step:
            self.assertLess(time.monotonic(), deadline, "no /train/state of step %d" % step)
            time.sleep(0.02)

    def test_1_starts_held_with_all_locomotives_joined(self):
        status = self.wait_held_at("held at the start", lambda s: all(s.joined))
        self.assertEqual(status.step, 0)
        self.assertEqual(len(status.joined), 3)
        self.assertEqual(sorted(status.incarnation), [1, 2, 3])
        self.assertEqual(status.reason, "holds at 3.000 km")
        self.assertAlmostEqual(status.location, 3000.0, places=9)
        self.check_shown(status)
        self.assertEqual(list(self.states[-1].notch), [0.0, 0.0, 0.0])
        self.assertGreater(self.states[-1].speed_limit, 10.0)

    def test_2_step_10_runs_ten_steps_and_holds(self):
        reply = self.step_lock("STEP", 10)
        self.assertTrue(reply.accepted, reply.message)
        self.assertEqual(reply.step, 0)
        status = self.wait_held_at("held after ten steps", lambda s: s.step > 0)
        self.assertEqual(status.step, 10)
        self.assertAlmostEqual(status.time, 0.020, places=12)
        self.assertAlmostEqual(status.header.stamp.to_sec(), 1.020, places=9)

    def test_3_refuses_what_cannot_be(self):
        for command, value in (("STEP", 0), ("STEP", 2.5), ("RUN_UNTIL_PLACE", 2.9), ("RUN_UNTIL_TIME", 0.01), ("GO", 0)):
            reply = self.step_lock(command, value)
            self.assertFalse(reply.accepted, command)
            self.assertIn(command, reply.message)
        self.assertEqual(self.wait_held_at("still held", lambda s: True).step, 10)

    def test_4_run_until_a_place_holds_there(self):
        self.assertTrue(self.step_lock("RUN_UNTIL_PLACE", 3.002).accepted)
        status = self.wait_held_at("held at 3.002 km", lambda s: s.step > 10)
        self.assertGreaterEqual(status.location, 3002.0)
        self.assertLess(status.location, 3002.0 + 0.002 * 2.0)  # within one step of 2 ms at less than 2 m/s
        self.check_shown(status)

    def test_4b_a_step_beside_the_telemetrys_grid_is_shown_too(self):
        before = self.status.step
        steps = 3 if (before + 3) % 10 else 4  # the telemetry comes every ten steps
        self.assertTrue(self.step_lock("STEP", steps).accepted)
        status = self.wait_held_at("held a few steps later", lambda s: s.step > before)
        self.assertEqual(status.step, before + steps)
        self.check_shown(status)

    def test_5_run_until_a_time_holds_there(self):
        self.assertTrue(self.step_lock("RUN_UNTIL_TIME", 2.0).accepted)
        status = self.wait_held_at("held at 2 s", lambda s: s.time > 1.9)
        self.assertEqual(status.step, 1000)

    def test_6_a_killed_locomotive_comes_back_and_the_run_goes_on(self):
        before = self.wait_held_at("held", lambda s: s.step == 1000)
        self.kill("/loco_2/loco")
        self.assertTrue(self.step_lock("STEP", 500).accepted)
        after = self.wait_held_at("500 steps later", lambda s: s.step == 1500)
        self.assertGreater(after.incarnation[1], max(before.incarnation))
        self.assertEqual(after.incarnation[0], before.incarnation[0])

    def test_7_telemetry_is_published_at_50_hz_of_simulation_time(self):
        self.wait_held_at("held", lambda s: s.step == 1500)
        self.assertGreater(len(self.states), 100)
        stamps = [state.header.stamp.to_nsec() for state in self.states if state.step % 10 == 0]  # others: where it was held
        self.assertTrue(all(b - a == 20000000 for a, b in zip(stamps, stamps[1:])), stamps[:5])
        self.assertEqual(len(self.states[0].vehicle_speed), 108)
        self.assertEqual(len(self.states[0].coupler_force), 107)
        self.assertGreater(self.energies[-1].loco_energy_rail[0], 0.0)

    def kill(self, node):
        uri = rosgraph.Master("/step_lock_rostest").lookupNode(node)
        pid = xmlrpc.client.ServerProxy(uri).getPid("/step_lock_rostest")[2]
        os.kill(pid, signal.SIGKILL)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ltd_sim", "step_lock_rostest", StepLockTest)
