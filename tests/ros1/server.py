"""An action server of ROS 1 for tests, `/fly`, whose goal says how it behaves. It writes what happens to the file LOG.

usage: server.py LOG
"""

import os
import signal
import sys
import threading
import time

import actionlib
import rospy
from actionlib.msg import TestAction, TestResult
from std_msgs.msg import Float32, String
from std_srvs.srv import SetBool

from server_goals import (ABORT, DEAF, DIE, DIE_ON_CANCEL, LATE_GOAL, LATE_RESULT, LOSE_RESULT, PEND, REJECT, SUCCEED,
                          TALK, TWICE)



class Server(actionlib.ActionServer):
    """A goal LATE_GOAL is read when its cancel has been, as a slow connection might deliver it."""

    def __init__(self, log):
        self.log = log
        self.cancelled = threading.Event()
        self.cancels = 0
        super().__init__("/fly", TestAction, self.on_goal, self.on_cancel, auto_start=False)

    def internal_goal_callback(self, message):
        if message.goal.goal == LATE_GOAL:
            self.say("seen")
            self.cancelled.wait(20)
        super().internal_goal_callback(message)

    def internal_cancel_callback(self, message):
        self.cancels += 1
        super().internal_cancel_callback(message)
        self.cancelled.set()
        self.say("cancelled")

    def on_goal(self, handle):
        how = handle.get_goal().goal
        self.say(f"goal {how}")
        if how == PEND:
            return
        if how == REJECT:
            handle.set_rejected(text="not today")
            return
        handle.set_accepted()
        if how == DIE:
            self.say("dies")
            os.kill(os.getpid(), signal.SIGKILL)
        if how in (SUCCEED, TWICE):
            handle.set_succeeded(TestResult(result=7))
        if how == TWICE:
            self.publish_result(handle.get_goal_status(), TestResult(result=8))
        if how == ABORT:
            handle.set_aborted(TestResult(result=3))
        if how == LOSE_RESULT:
            publisher, self.publish_result = self.publish_result, lambda *_: self.publish_status()
            handle.set_succeeded()
            self.publish_result = publisher

    def on_cancel(self, handle):
        how = handle.get_goal().goal
        if how == TALK:
            for _ in range(5):
                handle.publish_feedback(actionlib.msg.TestFeedback(feedback=1))
        if how == DIE_ON_CANCEL:
            os.kill(os.getpid(), signal.SIGKILL)
        if how == DEAF:
            return
        if how == LATE_RESULT:
            handle.set_succeeded(TestResult(result=9))  # it had arrived already
        else:
            handle.set_canceled()
        self.say(f"ended {how}")

    def say(self, text):
        with self.lock:
            self.log.write(text + "\n")


def main():
    rospy.init_node("robot", disable_signals=True)
    log = open(sys.argv[1], "a", buffering=1, encoding="utf-8")
    server = Server(log)
    battery = rospy.Publisher("/battery", Float32, queue_size=10)
    rospy.Subscriber("/say", String, lambda text: server.say(f"said {text.data}"))
    rospy.Service("/arm", SetBool, lambda request: (not request.data, ""))
    server.start()
    server.say("ready")
    for line in sys.stdin:  # values of the battery, by the test
        while not battery.get_num_connections():
            time.sleep(0.02)
        battery.publish(Float32(float(line)))


main()
os._exit(0)
