"""The goals of one action server: its five topics, and whether its process lives."""

from __future__ import annotations

import socket
import threading
import time
import xmlrpc.client
from typing import Any, Callable

import rosgraph
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray

from proskill.ros.adapter import Unfit
from proskill.ros1 import messages
from proskill.ros1.goal import Input, Output, State, reply

_TICK = 0.1  # seconds between two looks at what no message announces
_RESULT = 1.0  # seconds that a result may come after its status
_INPUTS = {
    GoalStatus.PENDING: Input.LISTED, GoalStatus.ACTIVE: Input.LISTED,
    GoalStatus.RECALLING: Input.CANCELLING, GoalStatus.PREEMPTING: Input.CANCELLING,
}
NAMES = {GoalStatus.SUCCEEDED: "succeeded", GoalStatus.ABORTED: "aborted",
         GoalStatus.REJECTED: "rejected", GoalStatus.PREEMPTED: "preempted",
         GoalStatus.RECALLED: "recalled"}


class _Quick(xmlrpc.client.Transport):
    """Calls that do not wait for long."""

    def make_connection(self, host: Any) -> Any:
        connection = super().make_connection(host)
        connection.timeout = 1.0
        return connection


def quick(uri: str) -> Any:
    return xmlrpc.client.ServerProxy(uri, transport=_Quick())


class Process:
    """A process of ROS, by its address and number."""

    def __init__(self, node: str) -> None:
        self.uri = rosgraph.Master(rospy.get_name()).lookupNode(node)
        self.pid = quick(self.uri).getPid(rospy.get_name())[2]

    def is_dead(self) -> bool:
        """Whether it is known not to exist. A process that does not answer may exist."""
        try:
            return bool(quick(self.uri).getPid(rospy.get_name())[2] != self.pid)
        except ConnectionRefusedError:
            return True
        except (OSError, socket.timeout, xmlrpc.client.Error):
            return False


class Goal:
    """A goal and what is to be done when it has ended."""

    def __init__(self, message: Any, patience: float,
                 ended: Callable[[Output, "Goal"], None]) -> None:
        self.message = message
        self.ended = ended
        self.state = State.WAITING
        self.deadline = time.monotonic() + patience
        self.process: Process | None = None
        self.status: Any = None  # of the server, the last one
        self.result: Any = None

    @property
    def id(self) -> str:
        return str(self.message.goal_id.id)


class Server:
    """The client's side of an action server."""

    def __init__(self, name: str, action: str, prefix: str, log: Callable[[str], None]) -> None:
        cls = messages.message_class(action)()
        if not hasattr(cls, "action_goal"):
            raise Unfit(f"`{action}` is not the type of an action: its name ends in Action")
        self.name, self._prefix, self._log = name, prefix, log
        self._goal_type = type(cls.action_goal)
        self._goals: dict[str, Goal] = {}
        self._lock = threading.RLock()
        self._connection: Any = None  # of the status; a new one may be of another server
        self._retired: list[Any] = []
        self._process: Process | None = None
        self._count = 0
        self._orphans: set[str] = set()
        self.has_swept = False  # goals of earlier runs have been cancelled
        name = rospy.resolve_name(name)
        self._goal = rospy.Publisher(name + "/goal", self._goal_type, queue_size=0)
        self._cancel = rospy.Publisher(name + "/cancel", GoalID, queue_size=0)
        self._result = rospy.Subscriber(name + "/result", type(cls.action_result), self._on_result,
                                        tcp_nodelay=True)
        self._status = rospy.Subscriber(name + "/status", GoalStatusArray, self._on_status,
                                        tcp_nodelay=True)
        threading.Thread(target=self._watch, name=name, daemon=True).start()

    def new_goal(self) -> Any:
        """An empty message with an id that no other goal has."""
        message = self._goal_type()
        with self._lock:
            self._count += 1
            message.goal_id.id = f"{self._prefix}{self._count}"
        return message

    def start(self, goal: Goal) -> None:
        with self._lock:
            self._goals[goal.id] = goal
            self._send_if_ready(goal)

    def stop(self, goal: Goal) -> None:
        with self._lock:
            self._give(goal, Input.STOP)

    def is_ready(self) -> bool:
        """Whether it can receive goals and cancels, and be heard."""
        with self._lock:
            if self._connection is None or self._process is None:
                return False
            node = self._connection["callerid"]
            return (self._goal.impl.has_connection(node) and self._cancel.impl.has_connection(node)
                    and self._hears(self._status, node) and self._hears(self._result, node))

    @staticmethod
    def _hears(subscriber: Any, node: str) -> bool:
        return any(each.callerid_pub == node for each in subscriber.impl.connections)

    # --- Messages of the server

    def _on_status(self, message: Any) -> None:
        with self._lock:
            if not self._is_current(message._connection_header):
                return
            listed = {each.goal_id.id: each for each in message.status_list}
            for goal in list(self._goals.values()):
                goal.status = listed.get(goal.id, goal.status)
                self._give(goal, self._input_of(listed.get(goal.id)))
            for orphan, status in listed.items():
                if self._is_ours(orphan) and orphan not in self._goals:
                    self._cancel_orphan(orphan, self._input_of(status))
            self.has_swept = self.has_swept or self.is_ready()

    def _is_current(self, connection: Any) -> bool:
        """A message of an earlier connection may come after one of the present connection."""
        if connection is self._connection:
            return True
        if any(connection is each for each in self._retired):
            return False
        self._retired = [*self._retired[-8:], self._connection]
        self._connection, self._process = connection, None
        return True

    @staticmethod
    def _input_of(status: Any) -> Input:
        return Input.UNLISTED if status is None else _INPUTS.get(status.status, Input.OVER)

    def _is_ours(self, goal: str) -> bool:
        """Also those of a process that had this node's name before, and was killed."""
        return goal.startswith(self._prefix.rsplit("/", 1)[0] + "/")

    def _cancel_orphan(self, orphan: str, given: Input) -> None:
        if reply(State.ENDED, given)[0] is Output.SEND_CANCEL:
            self._cancel.publish(GoalID(id=orphan))
            if orphan not in self._orphans and not orphan.startswith(self._prefix):
                self._log(f"cancelled a goal on {self.name} that an earlier run has left")
            self._orphans.add(orphan)

    def _on_result(self, message: Any) -> None:
        with self._lock:
            goal = self._goals.get(message.status.goal_id.id)
            if goal:  # late and second ones have none
                goal.status, goal.result = message.status, message.result
                self._give(goal, Input.RESULT)

    # --- What no message announces

    def _watch(self) -> None:
        while not rospy.is_shutdown():
            time.sleep(_TICK)
            self._identify()
            with self._lock:
                for goal in list(self._goals.values()):
                    self._send_if_ready(goal)
                    if time.monotonic() >= goal.deadline:
                        self._give(goal, Input.IMPATIENCE)
                suspects = [goal for goal in self._goals.values() if self._is_suspect(goal)]
            for goal in suspects:  # without the lock: this may take a second
                if goal.process and goal.process.is_dead():
                    with self._lock:
                        self._give(goal, Input.SERVER_DEAD)

    def _identify(self) -> None:
        connection = self._connection
        if connection is None or self._process is not None:
            return
        try:
            process = Process(connection["callerid"])
        except (OSError, xmlrpc.client.Error, rosgraph.MasterException):
            return  # next time
        with self._lock:
            if connection is self._connection:
                self._process = process

    def _is_suspect(self, goal: Goal) -> bool:
        return goal.process is not None and (goal.process is not self._process or not self.is_ready())

    def _send_if_ready(self, goal: Goal) -> None:
        if goal.state is State.WAITING and self.is_ready():
            self._give(goal, Input.SERVER_READY)

    # --- The protocol

    def _give(self, goal: Goal, given: Input) -> None:
        output, state = reply(goal.state, given)
        if state is not goal.state:
            goal.deadline = time.monotonic() + (_RESULT if state is State.FINISHED else float("inf"))
        goal.state = state
        if output is Output.SEND_GOAL:
            goal.process = self._process
            goal.message.goal_id.stamp = goal.message.header.stamp = rospy.Time.now()
            self._goal.publish(goal.message)
        elif output is Output.SEND_CANCEL:
            self._cancel.publish(GoalID(id=goal.id))
        if state is State.ENDED and self._goals.pop(goal.id, None) is not None:
            goal.ended(output, goal)
