"""Messages as bytes on DDS: dds/dds.h of ProSkill."""

from __future__ import annotations

import ctypes
import enum
from dataclasses import dataclass
from typing import Callable

RELIABLE, TRANSIENT_LOCAL = 1, 2


class Sample(ctypes.Structure):
    """Which write it was."""

    _fields_ = [("writer", ctypes.c_uint8 * 16), ("number", ctypes.c_int64)]


class _Event(ctypes.Structure):
    _fields_ = [("kind", ctypes.c_int32), ("endpoint", ctypes.c_int32), ("sample", Sample), ("related", Sample),
                ("message", ctypes.POINTER(ctypes.c_uint8)), ("size", ctypes.c_size_t)]


class Kind(enum.Enum):
    NOTHING = 0
    MESSAGE = 1
    MATCHED = 2
    UNMATCHED = 3
    JOINED = 4
    LEFT = 5


@dataclass(frozen=True)
class Write:
    """A write: the GUID of the writer, and its number there; of the other end of a match no number."""

    writer: bytes
    number: int = 0

    @property
    def host(self) -> bytes:
        """The participant that has the writer."""
        return self.writer[:12]


@dataclass(frozen=True)
class Event:
    kind: Kind
    endpoint: int
    source: Write
    related: Write
    message: bytes


def _write_of(sample: Sample) -> Write:
    return Write(bytes(sample.writer), sample.number)


class Dds:
    """A participant with its readers and writers."""

    def __init__(self, library: str, domain: int, name: str, loopback: bool, lease: float = 0) -> None:
        self._library = ctypes.CDLL(library)
        self._library.dds_open.restype = ctypes.c_void_p
        self._library.dds_open.argtypes = [ctypes.c_uint32, ctypes.c_char_p, ctypes.c_int, ctypes.c_double]
        self._node = ctypes.c_void_p(self._library.dds_open(domain, name.encode(), loopback, lease))
        if not self._node:
            raise OSError(f"DDS cannot join the domain {domain}")

    def close(self) -> None:
        self._library.dds_close(self._node)

    def reader(self, topic: str, type_name: str, qos: int, depth: int) -> int:
        return self._endpoint(self._library.dds_reader, topic, type_name, qos, depth)

    def writer(self, topic: str, type_name: str, qos: int, depth: int) -> int:
        return self._endpoint(self._library.dds_writer, topic, type_name, qos, depth)

    def _endpoint(self, make: Callable[..., int], topic: str, type_name: str, qos: int, depth: int) -> int:
        made = int(make(self._node, topic.encode(), type_name.encode(), ctypes.c_uint32(qos), ctypes.c_int32(depth)))
        if made < 0:
            raise OSError(f"DDS refuses the topic `{topic}` of type `{type_name}`")
        return made

    def guid(self, endpoint: int) -> bytes:
        guid = (ctypes.c_uint8 * 16)()
        self._library.dds_guid(self._node, ctypes.c_int32(endpoint), guid)
        return bytes(guid)

    def write(self, writer: int, message: bytes, related: Write | None = None) -> Write:
        given = Sample((ctypes.c_uint8 * 16)(*related.writer), related.number) if related else None
        written = Sample()
        if not self._library.dds_write(self._node, ctypes.c_int32(writer), message, ctypes.c_size_t(len(message)),
                                       ctypes.byref(given) if given else None, ctypes.byref(written)):
            raise OSError("DDS does not take the message")
        return _write_of(written)

    def next(self, milliseconds: int) -> Event:
        """Waits for the next event, and lets other threads run meanwhile."""
        event = _Event()
        self._library.dds_next(self._node, ctypes.c_int32(milliseconds), ctypes.byref(event))
        message = ctypes.string_at(event.message, event.size) if event.size else b""
        return Event(Kind(event.kind), event.endpoint, _write_of(event.sample), _write_of(event.related), message)
