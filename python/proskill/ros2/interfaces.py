"""Types of messages by name: of the platform file, of an installed ROS 2, or the common ones below.

A file of a ROS 2 package (`.msg`, `.srv`, `.action`) and the member `types` of a platform file say the same:
which fields a message has, in their order.
"""

from __future__ import annotations

import json
import os
import pathlib
import re
from typing import Any, Mapping

from proskill.ros.adapter import Unfit
from proskill.ros2.cdr import PRIMITIVES, Array, Struct, Type, initial

_PARTS = {"msg": (), "srv": ("request", "response"), "action": ("goal", "result", "feedback")}
_FIELD = re.compile(r"^([\w/]+(?:<=\d+)?)(\[(?:(?:<=)?\d+)?\])?\s+(\w+)\s*(.*)$")

# What most robots use, so that neither ROS 2 nor a definition is needed for it.
_COMMON = {
    "builtin_interfaces/msg/Time": "int32 sec\nuint32 nanosec",
    "builtin_interfaces/msg/Duration": "int32 sec\nuint32 nanosec",
    "std_msgs/msg/Empty": "",
    "std_msgs/msg/Header": "builtin_interfaces/Time stamp\nstring frame_id",
    **{f"std_msgs/msg/{name}": f"{name.lower()} data"
       for name in ("Bool", "String", "Float32", "Float64", "Int8", "Int16", "Int32", "Int64",
                    "UInt8", "UInt16", "UInt32", "UInt64")},
    "std_srvs/srv/Empty": "---",
    "std_srvs/srv/Trigger": "---\nbool success\nstring message",
    "std_srvs/srv/SetBool": "bool data\n---\nbool success\nstring message",
    "geometry_msgs/msg/Point": "float64 x\nfloat64 y\nfloat64 z",
    "geometry_msgs/msg/Vector3": "float64 x\nfloat64 y\nfloat64 z",
    "geometry_msgs/msg/Quaternion": "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1",
    "geometry_msgs/msg/Pose": "Point position\nQuaternion orientation",
    "geometry_msgs/msg/PoseStamped": "std_msgs/Header header\nPose pose",
    "geometry_msgs/msg/Twist": "Vector3 linear\nVector3 angular",
    "sensor_msgs/msg/BatteryState":
        "std_msgs/Header header\n" + "".join(f"float32 {name}\n" for name in (
            "voltage", "temperature", "current", "charge", "capacity", "design_capacity", "percentage")) +
        "uint8 power_supply_status\nuint8 power_supply_health\nuint8 power_supply_technology\nbool present\n"
        "float32[] cell_voltage\nfloat32[] cell_temperature\nstring location\nstring serial_number",
}


class Interfaces:
    """\\param given the member `types` of the platform file; \\param prefixes where ROS 2 is installed"""

    def __init__(self, given: Mapping[str, Any] | None = None, prefixes: str | None = None) -> None:
        self._given = given or {}
        self._prefixes = (os.environ.get("AMENT_PREFIX_PATH", "") if prefixes is None else prefixes).split(":")
        self._open: list[str] = []  # types that are being read

    def message(self, name: str) -> Struct:
        return self._parts(name, "msg")[""]

    def service(self, name: str) -> tuple[Struct, Struct]:
        parts = self._parts(name, "srv")
        return parts["request"], parts["response"]

    def action(self, name: str) -> tuple[Struct, Struct]:
        """The goal and the result; nobody reads the feedback."""
        parts = self._parts(name, "action")
        return parts["goal"], parts["result"]

    def _parts(self, name: str, kind: str) -> dict[str, Struct]:
        if name.split("/")[1:-1] != [kind]:
            raise Unfit(f"`{name}` must have the form package/{kind}/Type")
        if name in self._open:
            raise Unfit(f"the type `{name}` contains itself")
        self._open.append(name)
        try:
            if name in self._given:
                return self._parts_given(name, kind)
            return self._parts_of(name, kind, self._text(name))
        finally:
            self._open.remove(name)

    def _text(self, name: str) -> str:
        for prefix in filter(None, self._prefixes):
            file = pathlib.Path(prefix, "share", f"{name}.{name.split('/')[1]}")
            if file.is_file():
                return file.read_text(encoding="utf-8")
        if name in _COMMON:
            return _COMMON[name]
        raise Unfit(f"there is no type `{name}`: it is neither in `types` of the platform file nor below "
                    "AMENT_PREFIX_PATH")

    # --- As files of ROS 2 say it

    def _parts_of(self, name: str, kind: str, text: str) -> dict[str, Struct]:
        texts = re.split(r"(?m)^---\s*$", text)
        names = _PARTS[kind] or ("",)
        if len(texts) < len(names):
            texts += [""] * (len(names) - len(texts))
        return {part: self._struct_of(name, lines) for part, lines in zip(names, texts)}

    def _struct_of(self, name: str, text: str) -> Struct:
        fields: dict[str, Type] = {}
        values: dict[str, Any] = {}
        for line in text.splitlines():
            found = _FIELD.match(line.split("#")[0].strip())
            if not found or found[4].startswith("="):  # empty, or a constant
                continue
            fields[found[3]] = self._type(found[1] + (found[2] or ""), name)
            if found[4]:
                values[found[3]] = _value(found[4])
        return _filled(fields, values)

    def _type(self, text: str, inside: str) -> Type:
        """A type such as `float64`, `string<=10`, `Pose[2]`, `geometry_msgs/Pose[<=5]`."""
        found = re.match(r"^([\w/]+)(?:<=\d+)?(\[(<=)?(\d*)\])?$", text)
        if not found:
            raise Unfit(f"`{inside}`: there is no type `{text}`")
        of = found[1] if found[1] in PRIMITIVES else self._nested(found[1], inside)
        if not found[2]:
            return of
        return Array(of, int(found[4]) if found[4] and not found[3] else None)

    def _nested(self, name: str, inside: str) -> Struct:
        package, *rest = name.split("/")
        if not rest:
            if name in ("wstring", "wchar", "float128") or name.islower():
                raise Unfit(f"`{inside}`: there is no type `{name}`, or it is not supported")
            package, rest = inside.split("/")[0], [name]
        return self.message(f"{package}/msg/{rest[-1]}")

    # --- As the platform file says it

    def _parts_given(self, name: str, kind: str) -> dict[str, Struct]:
        given = self._given[name]
        if kind == "msg":
            return {"": self._struct_given(name, given)}
        wrong = [part for part in given if part not in _PARTS[kind]]
        if wrong:
            raise Unfit(f"`types`: `{name}` has {', '.join(_PARTS[kind])}, and no `{wrong[0]}`")
        return {part: self._struct_given(name, given.get(part, {})) for part in _PARTS[kind]}

    def _struct_given(self, name: str, given: Any) -> Struct:
        """Names may have dots: fields of fields."""
        if not isinstance(given, Mapping):
            raise Unfit(f"`types`: the fields of `{name}` must be an object")
        nested: dict[str, Any] = {}
        last: str | None = None
        for path, text in given.items():
            first, _, rest = path.partition(".")
            if rest:
                if first in nested and first != last:
                    raise Unfit(f"`types`: the fields of `{first}` in `{name}` must follow one another")
                nested.setdefault(first, {})[rest] = text
            else:
                nested[first] = text
            last = first
        return _filled({field: self._struct_given(name, text) if isinstance(text, Mapping)
                        else self._type(str(text), name) for field, text in nested.items()}, {})


def _filled(fields: dict[str, Type], values: dict[str, Any]) -> Struct:
    """DDS has no empty messages: ROS 2 gives them a byte."""
    return Struct(fields or {"structure_needs_at_least_one_member": "uint8"}, values)


def _value(text: str) -> Any:
    """The default value of a field."""
    text = {"true": "true", "false": "false"}.get(text.strip().lower(), text.strip())
    if text[:1] == "'":
        text = '"' + text.strip("'") + '"'
    try:
        return json.loads(text)
    except ValueError:
        return text


# --- Fields by their paths


def _steps(path: str) -> list[Any]:
    return [int(step[1:-1]) if step[0] == "[" else step for step in re.findall(r"\w+|\[\d+\]", path)]


def type_of(of: Type, path: str) -> Type:
    """The type of a field such as `pose.position.x` or `ranges[3]`."""
    for step in _steps(path):
        if isinstance(of, Struct) and isinstance(step, str) and step in of.fields:
            of = of.fields[step]
        elif isinstance(of, Array) and isinstance(step, int) and (of.count is None or step < of.count):
            of = of.of
        else:
            has = f"; it has {', '.join(of.fields)}" if isinstance(of, Struct) else ""
            raise Unfit(f"there is no field `{path}`: no `{step}`{has}")
    return of


def field(message: Any, path: str) -> Any:
    """The value of a field. Raises IndexError if a sequence is too short."""
    for step in _steps(path):
        message = message[step]
    return message


def set_field(of: Type, message: Any, path: str, value: Any) -> None:
    *before, last = _steps(path)
    for step in before:
        of, message = _entered(of, message, step)
    _entered(of, message, last)
    message[last] = value


def _entered(of: Type, message: Any, step: Any) -> tuple[Type, Any]:
    """A sequence grows to the element."""
    if isinstance(of, Array):
        while len(message) <= step:
            message.append(initial(of.of))
        return of.of, message[step]
    assert isinstance(of, Struct)
    return of.fields[step], message[step]
