#!/usr/bin/python3
"""A simulated robot with the interfaces of a real one: /move_base, /dock, /motors, /battery, /say."""

import math

import rospy
from actionlib import SimpleActionServer
from actionlib.msg import TestAction, TestResult
from move_base_msgs.msg import MoveBaseAction
from sensor_msgs.msg import BatteryState
from std_msgs.msg import String
from std_srvs.srv import SetBool

SPEED = 1.0  # metres per second
STEP = 0.05  # seconds


class Robot:
    def __init__(self) -> None:
        self.position = (0.0, 0.0)
        self.charge = 1.0
        self.capacity = float(rospy.get_param("~battery", 6.0))
        self.motors = False
        self.sensor = rospy.Publisher("/battery", BatteryState, queue_size=1, latch=True)
        self.base = SimpleActionServer("/move_base", MoveBaseAction, self.move, auto_start=False)
        self.station = SimpleActionServer("/dock", TestAction, self.dock, auto_start=False)
        rospy.Service("/motors", SetBool, self.switch)
        rospy.Subscriber("/say", String, lambda text: rospy.loginfo("robot: %s", text.data))
        rospy.Timer(rospy.Duration(0.2), lambda _: self.sensor.publish(BatteryState(percentage=self.charge)))
        self.base.start()
        self.station.start()

    def switch(self, request):
        self.motors = request.data
        return True, ""

    def move(self, goal) -> None:
        target = goal.target_pose.pose.position
        if not self.motors:
            self.base.set_aborted(text="the motors are off")
        elif self.drive((target.x, target.y), self.base):
            self.base.set_succeeded()

    def dock(self, goal) -> None:
        if self.drive((0.0, 0.0), self.station):
            self.charge = 1.0
            self.station.set_succeeded(TestResult(result=1))

    def drive(self, target, server) -> bool:
        """Whether it arrived; otherwise it was interrupted."""
        while (left := math.dist(self.position, target)) > 1e-6:
            if server.is_preempt_requested():
                server.set_preempted()
                return False
            part = min(1.0, SPEED * STEP / left)
            self.position = tuple(a + part * (b - a) for a, b in zip(self.position, target))
            self.charge = max(0.0, self.charge - STEP / self.capacity)
            rospy.sleep(STEP)
        return True


rospy.init_node("robot")
Robot()
rospy.spin()
