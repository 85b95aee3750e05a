"""How an action is performed: by a goal, a service or a message. What is called back here holds the node's lock."""

from __future__ import annotations

import time
from typing import Any

from proskill.ros.adapter import Run, Unfit, result_of
from proskill.ros2 import messages
from proskill.ros2.cdr import Struct
from proskill.ros2.dds import Write
from proskill.ros2.goal import Output
from proskill.ros2.interfaces import field, type_of
from proskill.ros2.node import Client, dds_type, has_settled
from proskill.ros2.server import Goal, Server


def check_cases(cases: list[dict[str, Any]], of: Struct) -> None:
    for case in cases:
        found = type_of(of, case["field"]) if "field" in case else "float64"
        if ("below" in case or "above" in case) and not messages.is_numeric(found):
            raise Unfit(f"field `{case['field']}` is not a number")


def result_in(cases: list[dict[str, Any]] | None, message: Any) -> str | None:
    try:
        return result_of(cases, message, field)
    except (IndexError, TypeError):  # a sequence that is too short
        return None


class ByGoal:
    """An action server performs it."""

    def __init__(self, mapping: dict[str, Any], servers: dict[str, Server], adapter: Any) -> None:
        self._mapping, self._patience, self._where = mapping, adapter.patience, adapter.where
        self._type, result = adapter.interfaces.action(mapping["type"])
        messages.check(self._type, mapping["fields"])
        for cases in mapping["results"].values():
            check_cases(cases, result)
        name = adapter.node.resolved(mapping["name"])
        if name not in servers:
            servers[name] = Server(adapter.node, mapping["name"], (mapping["type"], self._type, result),
                                   adapter.session, adapter.log)
        self._server = servers[name]

    def missing(self) -> str:
        return "" if self._server.host() and self._server.has_swept() else \
            f"there is no action server `{self._mapping['name']}` of type `{self._mapping['type']}` {self._where}"

    def start(self, run: Run, arguments: list[Any]) -> None:
        message = messages.filled(self._type, self._mapping["fields"], arguments)
        run.goal = Goal(message, self._patience, lambda output, goal: self._ended(run, output, goal))
        self._server.start(run.goal)

    def stop(self, run: Run) -> None:
        if run.goal:
            self._server.stop(run.goal)

    def _ended(self, run: Run, output: Output, goal: Goal) -> None:
        if output is Output.END_STOPPED:
            run.end("stopped")
        elif output is Output.END_FAILED:
            run.end("failed", text=f"the action server `{self._mapping['name']}` is not there, or has died")
        elif goal.is_garbled:
            run.end("failed", text=f"the result is not one of `{self._mapping['type']}` as it is defined here")
        else:
            state = "rejected" if output is Output.END_REJECTED else goal.terminal
            self._end_with(run, state, goal.result)

    def _end_with(self, run: Run, state: str, result: Any) -> None:
        found = result_in(self._mapping["results"].get(state), result)
        if found is not None:
            run.end("result", result=found)
        elif not state:
            run.end("failed", text=f"the action server `{self._mapping['name']}` has forgotten the goal")
        elif result is None and state != "rejected":
            run.end("failed", text=f"the goal was {state}, and its result was lost")
        else:
            run.end("failed", text=f"the goal was {state}, which has no result in the platform file")


class ByService:
    """A call of a service, which cannot be stopped: the run ends when it has answered."""

    def __init__(self, mapping: dict[str, Any], adapter: Any) -> None:
        self._mapping, self._node, self._where = mapping, adapter.node, adapter.where
        self._request, response = adapter.interfaces.service(mapping["type"])
        messages.check(self._request, mapping["fields"])
        check_cases(mapping["results"], response)
        self._called: list[Run] = []
        self._client = Client(adapter.node, mapping["name"], dds_type(mapping["type"]), self._request, response)
        adapter.node.ticks.append(self._tick)

    def missing(self) -> str:
        return "" if self._client.is_ready() else \
            f"there is no service `{self._mapping['name']}` of type `{self._mapping['type']}` {self._where}"

    def start(self, run: Run, arguments: list[Any]) -> None:
        request = messages.filled(self._request, self._mapping["fields"], arguments)
        with self._node.lock:
            self._called.append(run)
            self._client.call(request, lambda answer, source: self._answered(run, answer, source))

    def stop(self, run: Run) -> None:
        pass

    def _answered(self, run: Run, answer: Any, _: Write) -> None:
        if run not in self._called:
            return
        self._called.remove(run)
        found = result_in(self._mapping["results"], answer)
        if found is not None:
            run.end("result", result=found)
        elif answer is None:
            run.end("failed", text=f"the answer is not of type `{self._mapping['type']}`")
        else:
            run.end("failed", text="the answer has no result in the platform file")

    def _tick(self) -> None:
        if self._called and not self._client.servers():
            for run in self._called:
                run.end("failed", text=f"the service `{self._mapping['name']}` is not there, or has died")
            self._called = []


class ByTopic:
    """A message on a topic. The run has ended when a subscriber was there to get it."""

    def __init__(self, mapping: dict[str, Any], adapter: Any) -> None:
        self._mapping, self._node, self._patience = mapping, adapter.node, adapter.patience
        self._type = adapter.interfaces.message(mapping["type"])
        messages.check(self._type, mapping["fields"])
        self._waiting: list[tuple[Run, Any, float]] = []
        self._writer = adapter.node.advertise(mapping["name"], dds_type(mapping["type"]) + "_")
        adapter.node.ticks.append(self._tick)

    def missing(self) -> str:
        return ""

    def start(self, run: Run, arguments: list[Any]) -> None:
        message = messages.filled(self._type, self._mapping["fields"], arguments)
        with self._node.lock:
            self._waiting.append((run, message, time.monotonic() + self._patience))
            self._tick()

    def stop(self, run: Run) -> None:
        with self._node.lock:
            if any(each is run for each, _, _ in self._waiting):
                self._waiting = [each for each in self._waiting if each[0] is not run]
                run.end("stopped")

    def _tick(self) -> None:
        is_read = any(has_settled(since) for since in self._node.others(self._writer).values())
        waiting, self._waiting = self._waiting, []
        for run, message, end in waiting:
            if is_read:
                self._node.write(self._writer, self._type, message)
                run.end("result", result=self._mapping["result"])
            elif time.monotonic() >= end:
                run.end("failed", text=f"nobody reads the topic `{self._mapping['name']}`")
            else:
                self._waiting.append((run, message, end))
