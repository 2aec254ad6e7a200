#!/usr/bin/env python3
"""call_step_lock.py COMMAND VALUE: calls /train/step_lock and, for commands that end held, waits until it is."""

import sys

import rospy
from train_msgs.msg import TrainStatus
from train_msgs.srv import StepLock

DEADLINE_S = 60.0

command, value = sys.argv[1], float(sys.argv[2])
rospy.init_node("call_step_lock", anonymous=True, disable_rosout=True)
rospy.wait_for_service("/train/step_lock", DEADLINE_S)
while rospy.wait_for_message("/train/status", TrainStatus, DEADLINE_S).phase == TrainStatus.JOINING and command != "STOP":
    pass
reply = rospy.ServiceProxy("/train/step_lock", StepLock)(command, value)
print(reply)
if not reply.accepted:
    sys.exit(1)
while command in ("STEP", "RUN_UNTIL_TIME", "RUN_UNTIL_PLACE"):
    status = rospy.wait_for_message("/train/status", TrainStatus, DEADLINE_S)
    if status.phase == TrainStatus.HELD and status.step > reply.step:
        break
