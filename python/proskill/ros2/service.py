"""The other side of a service: for simulated robots and tests."""

from __future__ import annotations

from typing import Any, Callable

from proskill.ros2 import cdr
from proskill.ros2.cdr import Struct
from proskill.ros2.dds import RELIABLE, Write
from proskill.ros2.node import Node

Answer = Callable[[Any], None]


class Service:
    """Has requests answered, now or later."""

    def __init__(self, node: Node, name: str, type_name: str, messages: tuple[Struct, Struct],
                 take: Callable[[Any, Answer], None]) -> None:
        """\\param type_name of DDS, without `_Request_` and `_Response_`"""
        self._node, self._take = node, take
        self._request, self._response = messages
        self._writer = node.advertise(name + "Reply", type_name + "_Response_", RELIABLE, "rr/")
        node.listen(name + "Request", type_name + "_Request_", self._on_request, RELIABLE, "rq/")

    def _on_request(self, message: bytes, source: Write, related: Write) -> None:
        """The client says to which reader the answer goes, or else it goes to its writer."""
        to = Write(related.writer if any(related.writer) else source.writer, source.number)
        self._take(cdr.decode(self._request, message),
                   lambda answer: self._answer(answer, to))

    def _answer(self, answer: Any, to: Write) -> None:
        self._node.write(self._writer, self._response, answer, to)
