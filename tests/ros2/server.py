"""An action server of ROS 2 for tests, `/fly`, on the adapter's own messages. The goal says how it behaves, also as no
careful server would. It writes what happens to the file LOG, and reads commands from its input.

usage: server.py LIBRARY LOG
"""

import os
import pathlib
import signal
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from proskill.ros2 import cdr  # noqa: E402
from proskill.ros2.dds import RELIABLE, TRANSIENT_LOCAL  # noqa: E402
from proskill.ros2.interfaces import Interfaces  # noqa: E402
from proskill.ros2.node import Node, dds_type  # noqa: E402
from proskill.ros2.server import (CANCEL_REQUEST, CANCEL_RESPONSE, GOAL_RESPONSE, RESULT_REQUEST, STATUS_ARRAY,  # noqa: E402
                                  goal_request, id_of, info_of, result_response)
from proskill.ros2.service import Service  # noqa: E402
from server_goals import (ABORT, DEAF, DIE, DIE_ON_CANCEL, GONE, LATE_ACCEPT, LATE_REJECT, LATE_RESULT, LEAVE,  # noqa: E402
                          NO_ANSWER, NO_RESULT, REFUSE_ONCE, REJECT, SUCCEED, TALK, TWICE)

EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = 2, 3, 4, 5, 6
LEASE = 2.0  # seconds after which the client notices that it was killed


class Server:
    def __init__(self, node, log, types):
        self.node, self.log = node, log
        self.status, self.how, self.waiting, self.cancels = {}, {}, {}, 0
        self.undecided = {}
        goal, result = types.action("test_msgs/action/Fly")
        of = dds_type("test_msgs/action/Fly")
        with node.lock:
            self.statuses = node.advertise("/fly/_action/status", "action_msgs::msg::dds_::GoalStatusArray_",
                                           RELIABLE | TRANSIENT_LOCAL)
            feedback = types.message("std_msgs/msg/Int32")
            self.feedback_type = cdr.Struct({"goal_id": CANCEL_REQUEST.fields["goal_info"].fields["goal_id"],
                                             "feedback": feedback}, {})
            self.feedback = node.advertise("/fly/_action/feedback", of + "_FeedbackMessage_")
            Service(node, "/fly/_action/send_goal", of + "_SendGoal", (goal_request(goal), GOAL_RESPONSE), self.on_goal)
            Service(node, "/fly/_action/cancel_goal", "action_msgs::srv::dds_::CancelGoal",
                    (CANCEL_REQUEST, CANCEL_RESPONSE), self.on_cancel)
            Service(node, "/fly/_action/get_result", of + "_GetResult", (RESULT_REQUEST, result_response(result)),
                    self.on_result)
            Service(node, "/arm", dds_type("std_srvs/srv/SetBool"), types.service("std_srvs/srv/SetBool"),
                    lambda asked, answer: answer({"success": not asked["data"], "message": ""}))
            node.subscribe("/say", "std_msgs::msg::dds_::String_", types.message("std_msgs/msg/String"),
                           lambda text, _: self.say(f"said {text['data']}"), RELIABLE)

    def on_goal(self, request, answer):
        goal, how = bytes(request["goal_id"]["uuid"]), request["goal"]["how"]
        self.how[goal] = how
        self.say(f"goal {how}")
        if how in (LATE_ACCEPT, LATE_REJECT):
            self.undecided[goal] = answer  # until the test says `decide`
        elif how == REJECT:
            answer({"accepted": False, "stamp": {"sec": 0, "nanosec": 0}})
        else:
            self.accept(goal, answer)

    def decide(self):
        for goal, answer in self.undecided.items():
            if self.how[goal] == LATE_ACCEPT:
                self.accept(goal, answer)
            else:
                answer({"accepted": False, "stamp": {"sec": 0, "nanosec": 0}})
        self.undecided = {}

    def accept(self, goal, answer):
        how = self.how[goal]
        self.set(goal, EXECUTING)
        if how != NO_ANSWER:
            answer({"accepted": True, "stamp": {"sec": 1, "nanosec": 2}})
        self.say(f"accepted {how}")
        if how in (DIE, LEAVE):
            self.say("dies")
            if how == LEAVE:
                self.node._is_open = False  # says so, as an orderly process does
                self.node._dds.close()
            os.kill(os.getpid(), signal.SIGKILL)
        if how in (SUCCEED, GONE, NO_RESULT, TWICE):
            self.end(goal, SUCCEEDED)
        if how == ABORT:
            self.end(goal, ABORTED)

    def on_cancel(self, request, answer):
        goal = id_of(request["goal_info"])
        how = self.how.get(goal)
        if goal not in self.status:
            self.say(f"unknown {how}")
            answer({"return_code": 2, "goals_canceling": []})
            return
        if self.status[goal] > CANCELING:
            answer({"return_code": 3, "goals_canceling": []})
            return
        self.cancels += 1
        self.say(f"cancel {how}")
        if how == DIE_ON_CANCEL:
            os.kill(os.getpid(), signal.SIGKILL)
        if how == DEAF or (how == REFUSE_ONCE and self.cancels == 1):
            answer({"return_code": 1, "goals_canceling": []})
            return
        self.set(goal, CANCELING)
        answer({"return_code": 0, "goals_canceling": [info_of(goal)]})
        if how == TALK:
            for number in range(5):
                self.node.write(self.feedback, self.feedback_type, {"goal_id": {"uuid": list(goal)},
                                                                    "feedback": {"data": number}})
        self.end(goal, SUCCEEDED if how == LATE_RESULT else CANCELED)
        self.say(f"ended {how}")

    def on_result(self, request, answer):
        goal = bytes(request["goal_id"]["uuid"])
        how = self.how.get(goal)
        self.say(f"asked {how}")
        if how == NO_RESULT:
            return
        if goal not in self.status or how == GONE:
            answer({"status": 0, "result": {"code": 0}})
        elif self.status[goal] > CANCELING:
            self.answer_result(goal, answer)
        else:
            self.waiting.setdefault(goal, []).append(answer)

    def answer_result(self, goal, answer):
        code = {SUCCEED: 7, ABORT: 3, TWICE: 7}.get(self.how[goal], 9)
        answer({"status": self.status[goal], "result": {"code": code}})
        if self.how[goal] == TWICE:
            answer({"status": self.status[goal], "result": {"code": 8}})

    def end(self, goal, status):
        self.set(goal, status)
        for answer in self.waiting.pop(goal, []):
            self.answer_result(goal, answer)

    def set(self, goal, status):
        self.status[goal] = status
        self.publish()

    def publish(self):
        listed = [{"goal_info": info_of(goal), "status": status} for goal, status in self.status.items()
                  if self.how[goal] != GONE or status == EXECUTING]
        self.node.write(self.statuses, STATUS_ARRAY, {"status_list": listed})

    def say(self, text):
        self.log.write(text + "\n")


def main():
    log = open(sys.argv[2], "a", buffering=1, encoding="utf-8")
    types = Interfaces({"test_msgs/action/Fly": {"goal": {"how": "int32"}, "result": {"code": "int32"}}}, "")
    node = Node(sys.argv[1], int(os.environ["ROS_DOMAIN_ID"]), "server", lease=LEASE)
    server = Server(node, log, types)
    float32 = types.message("std_msgs/msg/Float32")
    battery = node.advertise("/battery", "std_msgs::msg::dds_::Float32_")
    charge = []  # said again and again, as sensors do
    node.ticks.append(lambda: charge and node.write(battery, float32, {"data": charge[-1]}))
    server.say("ready")
    for line in sys.stdin:  # values of the battery, and commands, by the test
        with node.lock:
            if line.strip() == "decide":
                server.decide()
                continue
            charge.append(float(line))
            node.write(battery, float32, {"data": charge[-1]})


main()
os._exit(0)
