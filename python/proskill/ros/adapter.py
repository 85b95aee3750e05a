"""The protocol of `proskill run`, for adapters to ROS."""

from __future__ import annotations

import threading
import time
from typing import Any, Callable

from proskill.connection import PROTOCOL, Connection
from proskill.ros.sensing import Sensor, holds

_LAST = 4.0  # seconds that goals have to stop at the end; `proskill run` waits for five


class Unfit(Exception):
    """A mapping that does not fit ROS, or what it names is not there."""


class Run:
    """A run of an action. It reports one end, the first."""

    def __init__(self, adapter: Adapter, number: int, performer: Any) -> None:
        self._adapter = adapter
        self.performer = performer
        self.number = number
        self.abandoned = False
        self.asked = False
        self.goal: Any = None

    def end(self, kind: str, **members: Any) -> None:
        self._adapter.end(self, kind, **members)

    def perform(self, part: Callable[..., None], *arguments: Any) -> None:
        """Does a part of the run. An exception ends the run; otherwise its skill would wait for ever."""
        try:
            part(self, *arguments)
        except Exception as error:
            self.end("failed", text=f"{type(error).__name__}: {error}")

    def perform_in_thread(self, part: Callable[..., None], *arguments: Any) -> None:
        threading.Thread(target=self.perform, args=(part, *arguments), daemon=True).start()


def result_of(cases: list[dict[str, Any]] | None, message: Any, field: Callable[[Any, str], Any]) -> str | None:
    """The name of the first result whose condition holds. None if the message that decides is gone."""
    for case in cases or []:
        if "field" not in case:
            return str(case["result"])
        if message is None:
            return None
        if holds(case, field(message, case["field"])):
            return str(case["result"])
    return None


class Adapter:
    """A node that performs the actions of a program. What ROS it speaks is said by its subclass."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._performers: dict[str, Any] = {}
        self._sensors: list[Sensor] = []
        self._runs: dict[int, Run] = {}
        self._changed = threading.Condition()
        self._is_ready = False
        self._early: list[tuple[str, dict[str, Any]]] = []
        self._is_ending = False
        self._subject = ""  # the skill that is being prepared
        self.patience = 5.0

    # --- What a subclass has

    def _join(self, settings: dict[str, Any]) -> None:
        """Becomes a node. Raises Unfit or OSError."""
        raise NotImplementedError

    def _performer(self, mapping: dict[str, Any]) -> Any:
        raise NotImplementedError

    def _sense(self, mapping: dict[str, Any]) -> None:
        raise NotImplementedError

    def _begin_watch(self) -> None:
        """The run begins."""

    def _leave(self) -> None:
        """The run is over."""

    # --- The run

    def run(self) -> int:
        """Performs actions until the run ends. Returns the exit code."""
        incoming = self._connection.messages()
        hello = next(incoming, None)
        if hello is None:
            return 0
        try:
            self._prepare(hello["settings"])
        except (Unfit, OSError) as error:
            self._connection.send("failed", text=str(error),
                                  **({"skill": self._subject} if self._subject else {}))
            return 1
        with self._changed:
            self._connection.send("ready", protocol=PROTOCOL)
            self._is_ready = True
            for kind, members in self._early:
                self._connection.send(kind, **members)
        self._begin_watch()
        for message in incoming:
            if message.get("type") == "end":
                break
            self._obey(message)
        self._stop_all()
        return 0

    def log(self, text: str) -> None:
        self._say("log", text=text)

    def end(self, run: Run, kind: str, **members: Any) -> None:
        """The end of a run. The first call counts."""
        with self._changed:
            if self._runs.pop(run.number, None) is None:
                return
            self._changed.notify_all()
        if not run.abandoned:
            self._connection.send(kind, run=run.number, **members)

    def _prepare(self, settings: dict[str, Any]) -> None:
        self.patience = settings["patience"]
        self._join(settings)
        for skill, mapping in settings["actions"].items():
            self._subject = skill
            self._performers[skill] = self._performer(mapping)
        self._subject = ""
        for mapping in settings["sensors"]:
            self._sense(mapping)
        patience = max(settings["startup"] - 2.0, settings["startup"] / 2)  # `proskill run` has a little more
        self._await_servers(self._connection.opened + patience)

    def _await_servers(self, end: float) -> None:
        for self._subject, performer in self._performers.items():
            why = performer.missing()
            while why and time.monotonic() < end:
                time.sleep(0.02)
                why = performer.missing()
            if why:
                raise Unfit(why)
        self._subject = ""

    def _new_sensor(self, mapping: dict[str, Any]) -> Sensor:
        sensor = Sensor(mapping["cases"], mapping["hysteresis"], mapping["timeout"], mapping["silent"])
        sensor.begin(time.monotonic())
        self._sensors.append(sensor)
        return sensor

    def _obey(self, message: dict[str, Any]) -> None:
        if message.get("type") == "start":
            started = Run(self, message["run"], self._performers[message["skill"]])
            with self._changed:
                self._runs[started.number] = started
            started.perform(started.performer.start, message["arguments"])
        run = self._runs.get(message.get("run", 0))
        if run and message.get("type") in ("stop", "abandon"):
            run.abandoned = message["type"] == "abandon"
            run.asked = True
            run.performer.stop(run)

    def _report(self, event: str | None) -> None:
        if event:
            self._say("event", name=event)

    def _say(self, kind: str, **members: Any) -> None:
        """Sends a message, but none before `ready`."""
        with self._changed:
            if self._is_ready:
                self._connection.send(kind, **members)
            else:
                self._early.append((kind, members))

    def _stop_all(self) -> None:
        self._is_ending = True
        with self._changed:
            runs = list(self._runs.values())
        for run in runs:
            run.asked = True
            run.performer.stop(run)
        with self._changed:
            self._changed.wait_for(lambda: not self._runs, _LAST)
        self._leave()
