#!/usr/bin/env python3
"""A simulated robot with the interfaces of a real one: /navigate_to_pose, /dock, /motors, /battery, /say.

usage: robot.py LIBRARY        which is libproskill_dds.so
"""

import json
import math
import os
import pathlib
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))
from proskill.ros2 import cdr  # noqa: E402
from proskill.ros2.dds import RELIABLE, TRANSIENT_LOCAL  # noqa: E402
from proskill.ros2.interfaces import Interfaces  # noqa: E402
from proskill.ros2.node import Node, dds_type  # noqa: E402
from proskill.ros2.server import (CANCEL_REQUEST, CANCEL_RESPONSE, GOAL_RESPONSE, RESULT_REQUEST, STATUS_ARRAY,  # noqa: E402
                                  goal_request, id_of, info_of, result_response)
from proskill.ros2.service import Service  # noqa: E402

SPEED = 1.0  # metres per second
STEP = 0.05  # seconds
CAPACITY = 6.0  # seconds of driving
EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = 2, 3, 4, 5, 6


class Action:
    """An action server, which performs each goal in a thread."""

    def __init__(self, node, types, name, type_name, perform):
        self.node, self.perform, self.status, self.results, self.asked = node, perform, {}, {}, {}
        goal, self.result = types.action(type_name)
        of, base = dds_type(type_name), f"{name}/_action/"
        Service(node, base + "send_goal", of + "_SendGoal", (goal_request(goal), GOAL_RESPONSE), self.accept)
        Service(node, base + "cancel_goal", "action_msgs::srv::dds_::CancelGoal", (CANCEL_REQUEST, CANCEL_RESPONSE),
                self.cancel)
        Service(node, base + "get_result", of + "_GetResult", (RESULT_REQUEST, result_response(self.result)), self.ask)
        self.statuses = node.advertise(base + "status", "action_msgs::msg::dds_::GoalStatusArray_",
                                       RELIABLE | TRANSIENT_LOCAL)

    def accept(self, request, answer):
        goal = bytes(request["goal_id"]["uuid"])
        self.set(goal, EXECUTING)
        answer({"accepted": True, "stamp": {"sec": int(time.time()), "nanosec": 0}})
        threading.Thread(target=self.run, args=(goal, request["goal"]), daemon=True).start()

    def run(self, goal, message):
        status, fields = self.perform(message, lambda: self.status[goal] == CANCELING)
        with self.node.lock:
            self.results[goal] = {"status": status, "result": {**cdr.initial(self.result), **fields}}
            self.set(goal, status)
            for answer in self.asked.pop(goal, []):
                answer(self.results[goal])

    def cancel(self, request, answer):
        goal = id_of(request["goal_info"])
        if self.status.get(goal) == EXECUTING:
            self.set(goal, CANCELING)
        is_canceling = self.status.get(goal) == CANCELING
        answer({"return_code": 0 if is_canceling else 3 if goal in self.status else 2,
                "goals_canceling": [info_of(goal)] if is_canceling else []})

    def ask(self, request, answer):
        goal = bytes(request["goal_id"]["uuid"])
        if goal in self.results or goal not in self.status:
            answer(self.results.get(goal, {"status": 0, "result": cdr.initial(self.result)}))
        else:
            self.asked.setdefault(goal, []).append(answer)

    def set(self, goal, status):
        self.status[goal] = status
        self.node.write(self.statuses, STATUS_ARRAY, {"status_list": [
            {"goal_info": info_of(each), "status": now} for each, now in self.status.items()]})


class Robot:
    def __init__(self, node, types):
        self.position, self.charge, self.motors = (0.0, 0.0), 1.0, False
        with node.lock:
            Action(node, types, "/navigate_to_pose", "nav2_msgs/action/NavigateToPose", self.navigate)
            Action(node, types, "/dock", "patrol_msgs/action/Dock", self.dock)
            Service(node, "/motors", dds_type("std_srvs/srv/SetBool"), types.service("std_srvs/srv/SetBool"), self.switch)
            node.subscribe("/say", dds_type("std_msgs/msg/String") + "_", types.message("std_msgs/msg/String"),
                           lambda text, _: print("robot:", text["data"], file=sys.stderr), RELIABLE)
            battery = types.message("sensor_msgs/msg/BatteryState")
            sensor = node.advertise("/battery", dds_type("sensor_msgs/msg/BatteryState") + "_")
            node.ticks.append(lambda: node.write(sensor, battery, {**cdr.initial(battery), "percentage": self.charge}))

    def switch(self, request, answer):
        self.motors = request["data"]
        answer({"success": True, "message": ""})

    def navigate(self, goal, is_cancelled):
        target = goal["pose"]["pose"]["position"]
        if not self.motors:
            return ABORTED, {"error_code": 1, "error_msg": "the motors are off"}
        return (SUCCEEDED if self.drive((target["x"], target["y"]), is_cancelled) else CANCELED), {}

    def dock(self, goal, is_cancelled):
        if not self.drive((0.0, 0.0), is_cancelled):
            return CANCELED, {}
        self.charge = 1.0
        return SUCCEEDED, {"is_charged": True}

    def drive(self, target, is_cancelled):
        """Whether it arrived; otherwise it was interrupted."""
        while (left := math.dist(self.position, target)) > 1e-6:
            if is_cancelled():
                return False
            part = min(1.0, SPEED * STEP / left)
            self.position = tuple(a + part * (b - a) for a, b in zip(self.position, target))
            self.charge = max(0.0, self.charge - STEP / CAPACITY)
            time.sleep(STEP)
        return True


def main():
    types = Interfaces(json.loads((HERE / "platform.json").read_text(encoding="utf-8"))["types"])
    Robot(Node(sys.argv[1], int(os.environ.get("ROS_DOMAIN_ID") or "0"), "robot"), types)
    threading.Event().wait()


main()
