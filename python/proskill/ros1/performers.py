"""How an action is performed: by a goal, a service or a message."""

from __future__ import annotations

import threading
import time
import warnings
from typing import Any

import rospy

from proskill.ros.adapter import Run, result_of
from proskill.ros1 import messages
from proskill.ros1.goal import Output
from proskill.ros1.server import NAMES, Goal, Server


def check_cases(cases: list[dict[str, Any]], message: Any) -> None:
    for case in cases:
        messages.field(message, case.get("field", ""))


class ByGoal:
    """An action server performs it."""

    def __init__(self, mapping: dict[str, Any], servers: dict[str, Server], adapter: Any) -> None:
        self._mapping = mapping
        action = messages.message_class(mapping["type"])()
        name = mapping["name"]
        if name not in servers:
            servers[name] = Server(name, mapping["type"], adapter.prefix, adapter.log)
        self._server = servers[name]
        self._patience = adapter.patience
        messages.check(action.action_goal.goal, mapping["fields"])
        for cases in mapping["results"].values():
            check_cases(cases, action.action_result.result)

    def missing(self) -> str:
        return "" if self._server.has_swept else \
            f"there is no action server `{self._mapping['name']}` of type `{self._mapping['type']}`"

    def start(self, run: Run, arguments: list[Any]) -> None:
        message = self._server.new_goal()
        messages.fill(message.goal, self._mapping["fields"], arguments)
        run.goal = Goal(message, self._patience, lambda output, goal: run.perform(self._end, output, goal))
        self._server.start(run.goal)

    def stop(self, run: Run) -> None:
        if run.goal:
            self._server.stop(run.goal)

    def _end(self, run: Run, output: Output, goal: Goal) -> None:
        if output is Output.END_STOPPED:
            run.end("stopped")
        elif output is Output.END_FAILED:
            run.end("failed", text=f"the action server `{self._mapping['name']}` is not there, has "
                                   "died, or has forgotten its goal")
        else:
            self._end_with(run, goal)

    def _end_with(self, run: Run, goal: Goal) -> None:
        state = NAMES.get(goal.status.status, "lost")
        cases = self._mapping["results"].get(state)
        found = result_of(cases, goal.result, messages.field)
        if found is not None:
            run.end("result", result=found)
            return
        why = "has no result in the platform file" if goal.result else "and its result was lost"
        run.end("failed", text=f"the goal was {state}, {why}: {goal.status.text or 'no text'}")


class ByService:
    """A call of a service, which cannot be stopped: the run ends when it has answered."""

    def __init__(self, mapping: dict[str, Any], adapter: Any) -> None:
        self._mapping = mapping
        self._class = messages.service_class(mapping["type"])
        messages.check(self._class._request_class(), mapping["fields"])
        check_cases(mapping["results"], self._class._response_class())

    def missing(self) -> str:
        try:
            rospy.wait_for_service(self._mapping["name"], timeout=0.01)
        except rospy.ROSException:
            return f"there is no service `{self._mapping['name']}` of type `{self._mapping['type']}`"
        return ""

    def start(self, run: Run, arguments: list[Any]) -> None:
        run.perform_in_thread(self._call, arguments)

    def stop(self, run: Run) -> None:
        pass

    def _call(self, run: Run, arguments: list[Any]) -> None:
        request = messages.fill(self._class._request_class(), self._mapping["fields"], arguments)
        try:
            answer = rospy.ServiceProxy(self._mapping["name"], self._class)(request)
        except rospy.ServiceException as error:
            run.end("failed", text=f"the service `{self._mapping['name']}`: {error}")
            return
        found = result_of(self._mapping["results"], answer, messages.field)
        if found is None:
            run.end("failed", text="the answer has no result in the platform file")
        else:
            run.end("result", result=found)


class ByTopic:
    """A message on a topic. The run ends when all subscribers that are there have been sent it."""

    def __init__(self, mapping: dict[str, Any], adapter: Any) -> None:
        self._mapping = mapping
        self._class = messages.message_class(mapping["type"])
        messages.check(self._class(), mapping["fields"])
        with warnings.catch_warnings():  # a queue might not be empty when the process ends
            warnings.simplefilter("ignore", SyntaxWarning)
            self._publisher = rospy.Publisher(mapping["name"], self._class, queue_size=None)
        self._patience = adapter.patience
        self._sending = threading.Lock()

    def missing(self) -> str:
        return ""

    def start(self, run: Run, arguments: list[Any]) -> None:
        run.perform_in_thread(self._publish, arguments)

    def stop(self, run: Run) -> None:
        run.end("stopped")  # also while a subscriber does not read

    def _publish(self, run: Run, arguments: list[Any]) -> None:
        message = messages.fill(self._class(), self._mapping["fields"], arguments)
        self._await_subscriber(run)
        with self._sending:  # what waits for a subscriber that does not read is not sent after its stop
            if run.asked:
                return
            if self._publisher.get_num_connections():
                self._publisher.publish(message)
                run.end("result", result=self._mapping["result"])
            else:
                run.end("failed", text=f"nobody reads the topic `{self._mapping['name']}`")

    def _await_subscriber(self, run: Run) -> None:
        end = time.monotonic() + self._patience
        while not self._publisher.get_num_connections() and time.monotonic() < end and not run.asked:
            time.sleep(0.02)
