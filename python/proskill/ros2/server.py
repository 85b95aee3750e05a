"""The goals of one action server: its three services, its status, and whether it lives."""

from __future__ import annotations

import hashlib
import os
import pathlib
import time
from typing import Any, Callable

from proskill.ros2.cdr import Array, Struct
from proskill.ros2.dds import RELIABLE, TRANSIENT_LOCAL, Write
from proskill.ros2.goal import Input, Output, State, reply
from proskill.ros2.node import Client, Node, dds_type, has_settled

_PAUSE = 2.0  # seconds until a cancel, and the question for a result, is repeated
# Seconds until a goal that has no skill is cancelled: one of this run, whose result may come before its status, and one
# of another run, whose adapter may not have been discovered yet. Adapters announce themselves every three seconds.
_GRACE, _LONG_GRACE = 1.0, 8.0

_UNKNOWN, _CANCELING = 0, 3
NAMES = {4: "succeeded", 5: "canceled", 6: "aborted"}
_NO_SUCH_GOAL, _HAS_ENDED = 2, 3  # codes of an answer to a cancel

_UUID = Struct({"uuid": Array("uint8", 16)}, {})
_TIME = Struct({"sec": "int32", "nanosec": "uint32"}, {})
_INFO = Struct({"goal_id": _UUID, "stamp": _TIME}, {})
STATUS_ARRAY = Struct({"status_list": Array(Struct({"goal_info": _INFO, "status": "int8"}, {}), None)}, {})
CANCEL_REQUEST = Struct({"goal_info": _INFO}, {})
CANCEL_RESPONSE = Struct({"return_code": "int8", "goals_canceling": Array(_INFO, None)}, {})
GOAL_RESPONSE = Struct({"accepted": "bool", "stamp": _TIME}, {})
RESULT_REQUEST = Struct({"goal_id": _UUID}, {})


def goal_request(goal: Struct) -> Struct:
    return Struct({"goal_id": _UUID, "goal": goal}, {})


def result_response(result: Struct) -> Struct:
    return Struct({"status": "int8", "result": result}, {})


def id_of(info: Any) -> bytes:
    return bytes(info["goal_id"]["uuid"])


def info_of(goal: bytes) -> Any:
    return {"goal_id": {"uuid": list(goal)}, "stamp": {"sec": 0, "nanosec": 0}}


class Session:
    """The numbers of our goals: of which node they are, of which run, which adapter of this run, and a counter."""

    def __init__(self, node: str, run: str) -> None:
        self._run = hashlib.sha256(b"proskill " + node.encode()).digest()[:6] + hashlib.sha256(run.encode()).digest()[:4]
        self._mine = self._run + os.urandom(3)
        self._count = 0
        self.participant = self.participant_of(self._mine)

    def new_id(self) -> bytes:
        self._count += 1
        return self._mine + self._count.to_bytes(3, "big")

    def is_ours(self, goal: bytes) -> bool:
        """Also of an earlier run."""
        return goal.startswith(self._run[:6])

    def is_of_this_run(self, goal: bytes) -> bool:
        """Of this adapter, or of one in whose place it was started."""
        return goal.startswith(self._run)

    def is_mine(self, goal: bytes) -> bool:
        return goal.startswith(self._mine)

    @staticmethod
    def participant_of(goal: bytes) -> str:
        """The name of the adapter that has sent a goal."""
        return f"proskill/{goal[6:13].hex()}"


def this_run() -> str:
    """What no other run has: the process that has started this one, and when it began."""
    parent = os.getppid()
    try:
        boot = pathlib.Path("/proc/sys/kernel/random/boot_id").read_text(encoding="utf-8").strip()
        began = pathlib.Path(f"/proc/{parent}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[19]
    except (OSError, IndexError):
        return os.urandom(8).hex()
    return f"{boot} {parent} {began}"


class Goal:
    """A goal and what is to be done when it has ended."""

    def __init__(self, message: Any, patience: float, ended: Callable[[Output, "Goal"], None]) -> None:
        self.message = message
        self.ended = ended
        self.id = b""
        self.state = State.WAITING
        self.deadline = time.monotonic() + patience
        self.host = b""  # the participant that has it, or is asked to take it
        self.is_listed = False  # by this participant
        self.terminal = ""  # its terminal state, if it is known
        self.result: Any = None
        self.is_garbled = False  # the result is not of its type


class Server:
    """The client's side of an action server."""

    def __init__(self, node: Node, name: str, types: tuple[str, Struct, Struct], session: Session,
                 log: Callable[[str], None]) -> None:
        type_name, goal, result = types
        self.name, self._node, self._session, self._log = name, node, session, log
        self._goals: dict[bytes, Goal] = {}
        self._listed: dict[bytes, dict[bytes, tuple[int, float]]] = {}  # by participant and goal: status, since when
        self._swept: dict[bytes, float] = {}  # goals without a skill: when they were last cancelled
        self._answered: set[bytes] = set()  # those whose cancel has been answered
        with node.lock:
            of, base = dds_type(type_name), f"{name}/_action/"
            self._goal = Client(node, base + "send_goal", of + "_SendGoal", goal_request(goal), GOAL_RESPONSE)
            self._cancel = Client(node, base + "cancel_goal", "action_msgs::srv::dds_::CancelGoal", CANCEL_REQUEST,
                                  CANCEL_RESPONSE)
            self._result = Client(node, base + "get_result", of + "_GetResult", RESULT_REQUEST,
                                  result_response(result))
            self._status = node.subscribe(base + "status", "action_msgs::msg::dds_::GoalStatusArray_", STATUS_ARRAY,
                                          self._on_status, RELIABLE | TRANSIENT_LOCAL)
            node.ticks.append(self._tick)

    def start(self, goal: Goal) -> None:
        with self._node.lock:
            goal.id = self._session.new_id()
            self._goals[goal.id] = goal
            self._send_if_ready(goal)

    def stop(self, goal: Goal) -> None:
        with self._node.lock:
            self._give(goal, Input.STOP)

    def host(self) -> bytes | None:
        """The participant that serves the action: the latest one, if a dead one is still known."""
        with self._node.lock:
            parts = [self._goal.servers(), self._cancel.servers(), self._result.servers(),
                     self._node.others(self._status)]
            since = {host: max(part[host] for part in parts) for host in parts[0]
                     if all(host in part for part in parts)}
            ready = [host for host in sorted(since, key=lambda host: since[host]) if has_settled(since[host])]
            return ready[-1] if ready else None

    # --- What the server says

    def _on_answer(self, goal: Goal, answer: Any, source: Write) -> None:
        if goal.state in (State.SENT, State.WITHDRAWING):
            goal.host = source.host
        if answer is not None:
            self._give(goal, Input.ACCEPTED if answer["accepted"] else Input.REJECTED)

    def _on_cancel(self, goal: Goal, answer: Any, source: Write) -> None:
        if answer is None or source.host != goal.host:
            return
        if answer["return_code"] in (_NO_SUCH_GOAL, _HAS_ENDED):
            self._give(goal, Input.FORGOTTEN)
        elif any(id_of(info) == goal.id for info in answer["goals_canceling"]):
            self._give(goal, Input.CANCELLING)

    def _on_result(self, goal: Goal, answer: Any, source: Write) -> None:
        if source.host != goal.host:
            return
        goal.is_garbled = answer is None
        if answer is None or answer["status"] == _UNKNOWN:
            self._give(goal, Input.FORGOTTEN)
        else:
            goal.terminal, goal.result = NAMES.get(answer["status"], ""), answer["result"]
            self._give(goal, Input.RESULT)

    def _on_status(self, message: Any, source: Write) -> None:
        statuses = {id_of(each["goal_info"]): each["status"] for each in message["status_list"]
                    if each["status"] != _UNKNOWN}  # some servers list goals that they have not accepted
        before, now = self._listed.get(source.host, {}), time.monotonic()
        self._listed[source.host] = {goal: (status, before.get(goal, (0, now))[1])
                                     for goal, status in statuses.items()}
        for goal in list(self._goals.values()):
            if goal.id in statuses:
                self._on_listed(goal, statuses[goal.id], source.host)
            elif goal.is_listed and goal.host == source.host:
                self._give(goal, Input.FORGOTTEN)

    def _on_listed(self, goal: Goal, status: int, host: bytes) -> None:
        if goal.state in (State.SENT, State.WITHDRAWING):
            goal.host = host
        if goal.host != host:
            return
        goal.is_listed = True
        if status in NAMES:
            goal.terminal = NAMES[status]
            self._give(goal, Input.OVER)
        else:
            self._give(goal, Input.CANCELLING if status == _CANCELING else Input.LISTED)

    # --- What no message says

    def _tick(self) -> None:
        now = time.monotonic()
        for goal in list(self._goals.values()):
            self._send_if_ready(goal)
            if goal.state is not State.WAITING and goal.host not in self._goal.servers():
                self._give(goal, Input.SERVER_DEAD)
            if now >= goal.deadline:
                goal.deadline = now + _PAUSE
                self._give(goal, Input.IMPATIENCE)
        self._listed = {host: goals for host, goals in self._listed.items() if host in self._node.participants}
        for orphan, since in self._orphans().items():
            if now - since > (_GRACE if self._session.is_of_this_run(orphan) else _LONG_GRACE):
                self._sweep(orphan, now)

    def _send_if_ready(self, goal: Goal) -> None:
        if goal.state is State.WAITING and self.host():
            self._give(goal, Input.SERVER_READY)

    def _orphans(self) -> dict[bytes, float]:
        """Goals of ours that run and have no skill, each with the time since when."""
        alive = set(self._node.participants.values())
        return {goal: since for goals in self._listed.values() for goal, (status, since) in goals.items()
                if status not in NAMES and status != _CANCELING and goal not in self._goals
                and self._session.is_ours(goal)
                and (self._session.is_of_this_run(goal) or self._session.participant_of(goal) not in alive)}

    def has_swept(self) -> bool:
        """Whether goals that an earlier adapter of this run has left know that they are to end."""
        with self._node.lock:
            return all(goal in self._answered for goal in self._orphans() if self._session.is_of_this_run(goal))

    def _sweep(self, orphan: bytes, now: float) -> None:
        """Cancels it, now and then until it has ended."""
        if now - self._swept.get(orphan, 0.0) < _PAUSE or reply(State.ENDED, Input.LISTED)[0] is not Output.SEND_CANCEL:
            return
        if orphan not in self._swept and not self._session.is_mine(orphan):
            self._log(f"cancelled a goal on {self.name} that an earlier adapter has left")
        self._swept[orphan] = now
        self._send_cancel(orphan, lambda answer, source: self._answered.add(orphan))

    # --- The protocol

    def _give(self, goal: Goal, given: Input) -> None:
        output, state = reply(goal.state, given)
        if state is not goal.state:
            goal.deadline = time.monotonic() + _PAUSE if state in (State.STOPPING, State.FINISHED, State.ASKING_AGAIN) \
                else float("inf")
        goal.state = state
        if output is Output.SEND_GOAL:
            goal.host = self.host() or b""
            self._goal.call({"goal_id": {"uuid": list(goal.id)}, "goal": goal.message},
                            lambda answer, source: self._on_answer(goal, answer, source))
        if output in (Output.SEND_CANCEL, Output.CANCEL_AND_ASK):
            self._send_cancel(goal.id, lambda answer, source: self._on_cancel(goal, answer, source))
        if output in (Output.ASK_RESULT, Output.CANCEL_AND_ASK):
            self._result.call({"goal_id": {"uuid": list(goal.id)}},
                              lambda answer, source: self._on_result(goal, answer, source))
        if state is State.ENDED and self._goals.pop(goal.id, None) is not None:
            goal.ended(output, goal)

    def _send_cancel(self, goal: bytes, take: Callable[[Any, Write], None]) -> None:
        self._cancel.call({"goal_info": info_of(goal)}, take)
