#!/usr/bin/env python3
"""Runs a held train for ten seconds and looks at it."""

import time
import unittest

import rospy
import rostest
from train_msgs.msg import TrainEnergy, TrainState, TrainStatus
from train_msgs.srv import StepLock

DEADLINE_S = 60.0  # of wall time, for a machine that is busy


class ExampleTest(unittest.TestCase):
    def wait_until_held(self, time_s):
        """Until the train stands in the lock at this simulation time. The status is latched: no message is missed."""
        deadline = time.monotonic() + DEADLINE_S
        while time.monotonic() < deadline:
            status = rospy.wait_for_message("/train/status", TrainStatus, DEADLINE_S)
            if status.phase == TrainStatus.HELD and status.time >= time_s:
                return
        self.fail("%.3f s: %s" % (status.time, status.reason))

    def test_after_ten_seconds_all_locomotives_pull_and_the_energy_is_accounted_for(self):
        rospy.wait_for_service("/train/step_lock", DEADLINE_S)
        step_lock = rospy.ServiceProxy("/train/step_lock", StepLock)
        self.wait_until_held(0.0)  # all locomotives have joined
        answer = step_lock("RUN_UNTIL_TIME", 10.0)
        self.assertTrue(answer.accepted, answer.message)
        self.wait_until_held(10.0)

        state = rospy.wait_for_message("/train/state", TrainState, DEADLINE_S)  # latched, too
        self.assertEqual(state.time, 10.0)
        self.assertEqual(list(state.notch), [1.0, 1.0, 1.0])
        self.assertGreater(min(state.traction), 10e3)
        energy = rospy.wait_for_message("/train/energy", TrainEnergy, DEADLINE_S)
        self.assertLess(abs(energy.residual_relative), 1e-6)


if __name__ == "__main__":
    rospy.init_node("example_rostest")
    rostest.rosrun("ltd_sim", "example_rostest", ExampleTest)
