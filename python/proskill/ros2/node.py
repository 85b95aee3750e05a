"""A node of ROS 2: topics and services on DDS, under the names that ROS 2 gives them.

One thread waits for events and calls back. It holds `lock`, as does everybody who calls a node, so what is called
back needs no lock of its own.
"""

from __future__ import annotations

import os
import threading
import time
import traceback
from dataclasses import dataclass, field
from typing import Any, Callable

from proskill.ros2 import cdr
from proskill.ros2.cdr import Struct
from proskill.ros2.dds import RELIABLE, Dds, Event, Kind, Write

_PATIENCE = 50  # milliseconds between two calls of `ticks`
_DEPTH = 100  # messages that wait to be read
_SETTLED = 0.2  # seconds until the other side, too, knows an endpoint that we know

OnMessage = Callable[[Any, Write], None]
OnBytes = Callable[[bytes, Write, Write], None]


def is_local(surroundings: Any = os.environ) -> bool:
    """Whether ROS 2 is to keep to this machine."""
    return bool(surroundings.get("ROS_LOCALHOST_ONLY") == "1"
                or surroundings.get("ROS_AUTOMATIC_DISCOVERY_RANGE") == "LOCALHOST")


def dds_type(name: str) -> str:
    """`pkg/msg/Pose` is `pkg::msg::dds_::Pose`, to which DDS adds a `_`."""
    package, kind, of = name.split("/")
    return f"{package}::{kind}::dds_::{of}"


@dataclass
class _Endpoint:
    """Who has the other ends of a reader or writer: the time from which on, by participant."""

    others: dict[bytes, float] = field(default_factory=dict)
    count: dict[bytes, int] = field(default_factory=dict)
    take: OnBytes | None = None


class Node:
    """\\param name of the participant"""

    def __init__(self, library: str, domain: int, name: str, namespace: str = "", lease: float = 0) -> None:
        self._dds = Dds(library, domain, name, is_local(), lease)
        self._namespace = "/" + namespace.strip("/") if namespace.strip("/") else ""
        self._endpoints: dict[int, _Endpoint] = {}
        self._is_open = True
        self._ticked = 0.0
        self.lock = threading.RLock()
        self.participants: dict[bytes, str] = {}  # those that are there; their names
        self.ticks: list[Callable[[], None]] = []  # called some twenty times a second
        self._thread = threading.Thread(target=self._listen, name="dds", daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._is_open = False
        self._thread.join()
        self._dds.close()

    def resolved(self, name: str) -> str:
        """Without the slash at its beginning."""
        return name[1:] if name.startswith("/") else f"{self._namespace}/{name}".lstrip("/")

    # --- Topics

    def subscribe(self, topic: str, type_name: str, of: Struct, take: OnMessage, qos: int) -> int:
        """Messages that are not of the type are ignored."""
        def taken(message: bytes, source: Write, _: Write) -> None:
            value = _decoded(of, message)
            if value is not None:
                take(value, source)

        return self.listen(topic, type_name, taken, qos)

    def listen(self, topic: str, type_name: str, take: OnBytes, qos: int = RELIABLE, prefix: str = "rt/") -> int:
        with self.lock:
            number = self._dds.reader(prefix + self.resolved(topic), type_name, qos, _DEPTH)
            self._endpoints[number] = _Endpoint(take=take)
            return number

    def advertise(self, topic: str, type_name: str, qos: int = RELIABLE, prefix: str = "rt/") -> int:
        with self.lock:
            number = self._dds.writer(prefix + self.resolved(topic), type_name, qos, _DEPTH)
            self._endpoints[number] = _Endpoint()
            return number

    def write(self, writer: int, of: Struct, message: Any, related: Write | None = None) -> Write:
        return self._dds.write(writer, cdr.encode(of, message), related)

    def others(self, endpoint: int) -> dict[bytes, float]:
        """The participants at the other end, each with the time since when."""
        return self._endpoints[endpoint].others

    def guid(self, endpoint: int) -> bytes:
        return self._dds.guid(endpoint)

    def guids(self) -> tuple[list[bytes], list[bytes]]:
        """Of all readers, and of all writers."""
        with self.lock:
            readers = [self.guid(number) for number, each in self._endpoints.items() if each.take]
            return readers, [self.guid(number) for number, each in self._endpoints.items() if not each.take]

    # --- Events

    def _listen(self) -> None:
        """A callback that fails would leave skills waiting: the process ends, and with it its skills."""
        try:
            while self._is_open:
                event = self._dds.next(_PATIENCE)
                with self.lock:
                    self._handle(event)
        except Exception:
            traceback.print_exc()
            os._exit(1)

    def _handle(self, event: Event) -> None:
        if event.kind is Kind.MESSAGE:
            self._take(event)
        elif event.kind in (Kind.MATCHED, Kind.UNMATCHED):
            self._match(event.endpoint, event.source.host, event.kind is Kind.MATCHED)
        elif event.kind is Kind.JOINED:
            self.participants[event.source.host] = event.message.decode("utf-8", "replace")
        elif event.kind is Kind.LEFT:
            self.participants.pop(event.source.host, None)
        now = time.monotonic()
        if now - self._ticked >= _PATIENCE / 1000:
            self._ticked = now
            for tick in self.ticks:
                tick()

    def _take(self, event: Event) -> None:
        take = self._endpoints[event.endpoint].take
        if take:
            take(event.message, event.source, event.related)

    def _match(self, number: int, host: bytes, is_there: bool) -> None:
        endpoint = self._endpoints[number]
        endpoint.count[host] = endpoint.count.get(host, 0) + (1 if is_there else -1)
        if not is_there and endpoint.count[host] <= 0:
            endpoint.others.pop(host, None)
        elif is_there:
            endpoint.others.setdefault(host, time.monotonic())


def _decoded(of: Struct, message: bytes) -> Any:
    """None if it is not a message of the type."""
    try:
        return cdr.decode(of, message)
    except cdr.Garbled:
        return None


def has_settled(since: float) -> bool:
    return time.monotonic() - since >= _SETTLED


class Client:
    """Calls a service. Fast DDS says to which request an answer belongs by the identity of its write."""

    def __init__(self, node: Node, name: str, type_name: str, request: Struct, response: Struct) -> None:
        """\\param type_name of DDS, without `_Request_` and `_Response_`"""
        self._node = node
        self._request = request
        self._response = response
        self._waiting: dict[int, OnMessage] = {}
        self._reader = node.listen(f"{name}Reply", f"{type_name}_Response_", self._take, RELIABLE, "rr/")
        self._writer = node.advertise(f"{name}Request", f"{type_name}_Request_", RELIABLE, "rq/")
        # Servers answer to the reader, if they know it, or else to the writer.
        self._answers_to = Write(node.guid(self._reader))
        self._us = {node.guid(self._reader), node.guid(self._writer)}

    def servers(self) -> dict[bytes, float]:
        """The participants that serve it, each with the time since when."""
        readers, writers = self._node.others(self._writer), self._node.others(self._reader)
        return {host: max(since, writers[host]) for host, since in readers.items() if host in writers}

    def is_ready(self) -> bool:
        with self._node.lock:
            return any(has_settled(since) for since in self.servers().values())

    def call(self, message: Any, take: OnMessage) -> None:
        """The answer is None if it is not of the type."""
        with self._node.lock:
            written = self._node.write(self._writer, self._request, message, self._answers_to)
            self._waiting[written.number] = take

    def _take(self, message: bytes, source: Write, related: Write) -> None:
        take = self._waiting.pop(related.number, None) if related.writer in self._us else None
        if take:
            take(_decoded(self._response, message), source)
