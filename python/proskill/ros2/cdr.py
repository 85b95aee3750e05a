"""Messages of ROS 2 as CDR, the encoding of DDS. A type is data: nothing is generated.

A message is a dictionary of its fields; its fields may be dictionaries and lists.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any, Union

_CODES = {"bool": "?", "byte": "B", "char": "B", "octet": "B", "uint8": "B", "int8": "b", "int16": "h", "uint16": "H",
          "int32": "i", "uint32": "I", "int64": "q", "uint64": "Q", "float32": "f", "float64": "d"}
PRIMITIVES = frozenset(_CODES) | {"string"}
_HEADER = b"\0\1\0\0"  # little endian


@dataclass(frozen=True)
class Struct:
    """Fields in their order, and their initial values."""

    fields: dict[str, "Type"]
    initial: dict[str, Any]


@dataclass(frozen=True)
class Array:
    of: "Type"
    count: int | None  # None: any number, which is sent as well


Type = Union[str, Struct, Array]  # a string: one of PRIMITIVES


class Garbled(ValueError):
    """Bytes that are not a message of the type."""


def initial(of: Type) -> Any:
    """The value of a field that nobody sets."""
    if isinstance(of, Struct):
        return {name: of.initial[name] if name in of.initial else initial(each) for name, each in of.fields.items()}
    if isinstance(of, Array):
        return [initial(of.of) for _ in range(of.count or 0)]
    return "" if of == "string" else False if of == "bool" else 0.0 if of.startswith("float") else 0


def encode(of: Type, value: Any) -> bytes:
    """Raises struct.error, TypeError or ValueError if the value is not one of the type."""
    out = bytearray()
    _put(out, of, value)
    return _HEADER + bytes(out)


def _put(out: bytearray, of: Type, value: Any) -> None:
    if isinstance(of, Struct):
        for name, each in of.fields.items():
            _put(out, each, value[name])
    elif isinstance(of, Array):
        _put_array(out, of, value)
    elif of == "string":
        text = value.encode("utf-8") + b"\0"
        _put(out, "uint32", len(text))
        out += text
    else:
        packed = struct.pack("<" + _CODES[of], value)
        out += b"\0" * (-len(out) % len(packed)) + packed


def _put_array(out: bytearray, of: Array, value: list[Any]) -> None:
    if of.count is None:
        _put(out, "uint32", len(value))
    elif len(value) != of.count:
        raise ValueError(f"there must be {of.count} elements, not {len(value)}")
    for each in value:
        _put(out, of.of, each)


def decode(of: Type, message: bytes) -> Any:
    """Raises Garbled."""
    if len(message) < 4 or message[0] != 0 or message[1] not in (0, 1):
        raise Garbled("not CDR")
    try:
        return _Reader(message[4:], "<" if message[1] else ">").value(of)
    except (struct.error, UnicodeDecodeError) as error:
        raise Garbled(str(error)) from None


class _Reader:
    def __init__(self, data: bytes, order: str) -> None:
        self._data = data
        self._order = order
        self._at = 0

    def value(self, of: Type) -> Any:
        if isinstance(of, Struct):
            return {name: self.value(each) for name, each in of.fields.items()}
        if isinstance(of, Array):
            return self._array(of)
        return self._string() if of == "string" else self._number(of)

    def _number(self, of: str) -> Any:
        code = self._order + _CODES[of]
        size = struct.calcsize(code)
        self._at += -self._at % size
        found = struct.unpack_from(code, self._data, self._at)[0]
        self._at += size
        return found

    def _array(self, of: Array) -> list[Any]:
        count = self._number("uint32") if of.count is None else of.count
        if count > len(self._data) - self._at:  # none is smaller than a byte
            raise Garbled(f"a sequence of {count} elements")
        return self._numbers(of.of, count) if isinstance(of.of, str) and of.of in _CODES else \
            [self.value(of.of) for _ in range(count)]

    def _numbers(self, of: str, count: int) -> list[Any]:
        """At once: pictures are long."""
        if not count:
            return []
        code = f"{self._order}{count}{_CODES[of]}"
        size = struct.calcsize(self._order + _CODES[of])
        self._at += -self._at % size
        found = list(struct.unpack_from(code, self._data, self._at))
        self._at += size * count
        return found

    def _string(self) -> str:
        size = self._number("uint32")
        text = self._data[self._at:self._at + size]
        if len(text) != size:
            raise Garbled("a string that is too short")
        self._at += size
        return text.rstrip(b"\0").decode("utf-8")
