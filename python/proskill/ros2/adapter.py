"""ROS 2 as the adapter to `proskill run` sees it."""

from __future__ import annotations

import os
import time
from typing import Any

from proskill.connection import Connection
from proskill.ros import adapter
from proskill.ros.adapter import Unfit
from proskill.ros2 import messages
from proskill.ros2.dds import RELIABLE, TRANSIENT_LOCAL, Write
from proskill.ros2.interfaces import Interfaces, field, type_of
from proskill.ros2.node import Node, dds_type, is_local
from proskill.ros2.performers import ByGoal, ByService, ByTopic
from proskill.ros2.presence import Presence
from proskill.ros2.server import Server, Session, this_run


class Adapter(adapter.Adapter):
    """A node that performs the actions of a program."""

    def __init__(self, connection: Connection) -> None:
        super().__init__(connection)
        self._servers: dict[str, Server] = {}
        self.node: Node
        self.session: Session
        self.interfaces: Interfaces
        self.where = ""
        self._name = ("", "")  # namespace and name

    def _join(self, settings: dict[str, Any]) -> None:
        self.interfaces = Interfaces(settings["types"])
        self.session = Session(f"{settings['namespace']}/{settings['node']}", this_run())
        self._name = (settings["namespace"], settings["node"])
        domain = _domain(settings)
        self.where = f"in domain {domain}{' on this machine' if is_local() else ''}"
        self.node = Node(settings["library"], domain, self.session.participant, settings["namespace"])
        self.node.ticks.append(self._tick)

    def _performer(self, mapping: dict[str, Any]) -> Any:
        if mapping["kind"] == "action":
            return ByGoal(mapping, self._servers, self)
        return (ByService if mapping["kind"] == "service" else ByTopic)(mapping, self)

    def _sense(self, mapping: dict[str, Any]) -> None:
        of, path = self.interfaces.message(mapping["type"]), mapping["field"]
        wants = any("below" in case or "above" in case for case in mapping["cases"])
        if wants and not messages.is_numeric(type_of(of, path)):
            raise Unfit(f"`{mapping['name']}`: field `{path}` of `{mapping['type']}` is not a number")
        type_of(of, path)
        sensor = self._new_sensor(mapping)
        heard: dict[bytes, int] = {}  # by writer: its last message

        def take(message: Any, source: Write) -> None:
            if source.number <= heard.get(source.writer, 0):
                return
            heard[source.writer] = source.number
            try:
                self._report(sensor.take(field(message, path), time.monotonic()))
            except (IndexError, TypeError):
                pass  # a sequence that is too short has no such value: silence

        # The first reader suits every publisher; the second gets what a late subscriber may have.
        for qos in (0, RELIABLE | TRANSIENT_LOCAL):
            self.node.subscribe(mapping["topic"], dds_type(mapping["type"]) + "_", of, take, qos)

    def _await_servers(self, end: float) -> None:
        with self.node.lock:
            Presence(self.node, *self._name)
        super()._await_servers(end)

    def _tick(self) -> None:
        for sensor in self._sensors:
            if not self._is_ending:
                self._report(sensor.silence(time.monotonic()))

    def _leave(self) -> None:
        self.node.close()


def _domain(settings: dict[str, Any]) -> int:
    """Of the platform file, or of the surroundings."""
    if settings["domain"] is not None:
        return int(settings["domain"])
    text = os.environ.get("ROS_DOMAIN_ID", "") or "0"
    if not text.isdigit() or int(text) > 232:
        raise Unfit(f"ROS_DOMAIN_ID must be a number from 0 to 232, not `{text}`")
    return int(text)
