"""The protocol of `proskill run` on one side, ROS 1 on the other."""

from __future__ import annotations

import os
import threading
import time
from typing import Any

import rosgraph
import rospy

from proskill.connection import PROTOCOL, Connection
from proskill.ros1 import messages
from proskill.ros1.performers import ByGoal, ByService, ByTopic, Run
from proskill.ros1.sensing import Sensor, is_number
from proskill.ros1.server import Server, quick

_TICK = 0.05  # seconds between two looks for silent topics
_LAST = 4.0  # seconds that goals have to stop at the end; `proskill run` waits for five


class Adapter:
    """A node that performs the actions of a program."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._performers: dict[str, Any] = {}
        self._servers: dict[str, Server] = {}
        self._sensors: list[Sensor] = []
        self._runs: dict[int, Run] = {}
        self._changed = threading.Condition()
        self._sensing = threading.Lock()
        self._is_ready = False
        self._early: list[tuple[str, dict[str, Any]]] = []
        self._is_ending = False
        self._subject = ""  # the skill that is being prepared
        self.prefix = ""
        self.patience = 5.0

    def run(self) -> int:
        """Performs actions until the run ends. Returns the exit code."""
        incoming = self._connection.messages()
        hello = next(incoming, None)
        if hello is None:
            return 0
        try:
            self._prepare(hello["settings"])
        except (messages.Unfit, rospy.ROSException, OSError) as error:
            self._connection.send("failed", text=str(error),
                                  **({"skill": self._subject} if self._subject else {}))
            return 1
        with self._changed:
            self._connection.send("ready", protocol=PROTOCOL)
            self._is_ready = True
            for kind, members in self._early:
                self._connection.send(kind, **members)
        threading.Thread(target=self._watch, daemon=True).start()
        for message in incoming:
            if message.get("type") == "end":
                break
            self._obey(message)
        self._stop_all()
        return 0

    def log(self, text: str) -> None:
        self._say("log", text=text)

    def end(self, run: Run, kind: str, **members: Any) -> None:
        """The end of a run; called once."""
        with self._changed:
            self._runs.pop(run.number, None)
            self._changed.notify_all()
        if not run.abandoned:
            self._connection.send(kind, run=run.number, **members)

    # --- Before the run

    def _prepare(self, settings: dict[str, Any]) -> None:
        node, self.patience = settings["node"], settings["patience"]
        self.prefix = f"proskill/{node}/{os.getpid()}-{time.time_ns()}:"
        uri = rosgraph.get_master_uri()
        try:
            quick(uri).getPid("/" + node)
        except OSError as error:
            raise messages.Unfit(f"no ROS master answers at {uri} ({error}): start roscore, or set "
                                 "ROS_MASTER_URI") from None
        rospy.init_node(node, disable_signals=True)
        rospy.on_shutdown(self._on_shutdown)
        for skill, mapping in settings["actions"].items():
            self._subject = skill
            self._performers[skill] = self._performer(mapping)
        self._subject = ""
        for mapping in settings["sensors"]:
            self._sense(mapping)
        self._await_servers(time.monotonic() + max(settings["startup"] - 2.0, settings["startup"] / 2))

    def _performer(self, mapping: dict[str, Any]) -> Any:
        if mapping["kind"] == "action":
            return ByGoal(mapping, self._servers, self)
        return (ByService if mapping["kind"] == "service" else ByTopic)(mapping, self)

    def _sense(self, mapping: dict[str, Any]) -> None:
        cls, path, cases = messages.message_class(mapping["type"]), mapping["field"], mapping["cases"]
        value = messages.field(cls(), path) if "[" not in path else None
        wants = any("below" in case or "above" in case for case in cases)
        if wants and value is not None and not is_number(value):
            raise messages.Unfit(f"`{mapping['name']}`: field `{path}` of `{mapping['type']}` is not a number")
        sensor = Sensor(cases, mapping["hysteresis"], mapping["timeout"], mapping["silent"])
        sensor.begin(time.monotonic())
        self._sensors.append(sensor)

        def on_message(message: Any) -> None:
            try:
                with self._sensing:
                    self._report(sensor.take(messages.field(message, path), time.monotonic()))
            except (IndexError, TypeError):
                pass  # a list that is too short has no such value: silence

        rospy.Subscriber(mapping["topic"], cls, on_message, tcp_nodelay=True)

    def _await_servers(self, end: float) -> None:
        for self._subject, performer in self._performers.items():
            why = performer.missing()
            while why and time.monotonic() < end:
                time.sleep(0.02)
                why = performer.missing()
            if why:
                raise messages.Unfit(why)
        self._subject = ""

    # --- During the run

    def _obey(self, message: dict[str, Any]) -> None:
        if message.get("type") == "start":
            run = Run(self, message["run"], self._performers[message["skill"]])
            with self._changed:
                self._runs[run.number] = run
            self._begin(run, message)
        run = self._runs.get(message.get("run", 0))
        if run and message.get("type") in ("stop", "abandon"):
            run.abandoned = message["type"] == "abandon"
            run.asked = True
            run.performer.stop(run)

    def _begin(self, run: Run, message: dict[str, Any]) -> None:
        try:
            run.performer.start(run, message["arguments"])
        except Exception as error:  # an argument without a value, for example
            run.end("failed", text=f"{type(error).__name__}: {error}")

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

    def _watch(self) -> None:
        """Silent topics, and the master."""
        asked, is_there = 0.0, True
        while not self._is_ending:
            time.sleep(_TICK)
            with self._sensing:
                for sensor in self._sensors:
                    self._report(sensor.silence(time.monotonic()))
            if time.monotonic() - asked > 1.0:
                asked, was_there, is_there = time.monotonic(), is_there, self._has_master()
                if was_there and not is_there:
                    self.log("the ROS master is gone: what is connected goes on, and nothing new connects")

    @staticmethod
    def _has_master() -> bool:
        try:
            quick(rosgraph.get_master_uri()).getPid(rospy.get_name())
        except OSError:
            return False
        return True

    def _on_shutdown(self) -> None:
        if not self._is_ending:
            self._connection.send("failed", text="ROS has ended this node, perhaps for another one with its name")
            os._exit(1)

    def _stop_all(self) -> None:
        self._is_ending = True
        with self._changed:
            runs = list(self._runs.values())
        for run in runs:
            run.asked = True
            run.performer.stop(run)
        with self._changed:
            self._changed.wait_for(lambda: not self._runs, _LAST)
        rospy.signal_shutdown("the run is over")
