"""Messages of ROS by the names of their types and the paths of their fields."""

from __future__ import annotations

import re
from typing import Any

import roslib.message

from proskill.ros.adapter import Unfit

# A value of each type of argument, to check mappings before the run begins.
_SAMPLES = {"float": 1.0, "int": 1, "nat": 1, "bool": True}


def message_class(name: str) -> Any:
    return _found(roslib.message.get_message_class(name), name)


def service_class(name: str) -> Any:
    return _found(roslib.message.get_service_class(name), name)


def _found(found: Any, name: str) -> Any:
    if found is None:
        package = name.split("/")[0].replace("_", "-")
        raise Unfit(f"there is no type `{name}` (perhaps apt-get install python3-{package})")
    return found


def _steps(path: str) -> list[Any]:
    return [int(step[1:-1]) if step[0] == "[" else step for step in re.findall(r"\w+|\[\d+\]", path)]


def field(message: Any, path: str) -> Any:
    """The value of a field such as `pose.position.x` or `ranges[3]`; the message for an empty path."""
    for step in _steps(path):
        try:
            message = message[step] if isinstance(step, int) else getattr(message, step)
        except AttributeError:
            raise Unfit(f"`{_type_of(message)}` has no field `{step}`; it has "
                        f"{', '.join(getattr(message, '__slots__', [])) or 'none'}") from None
    return message


def _type_of(message: Any) -> str:
    return str(getattr(message, "_type", type(message).__name__))


def fill(message: Any, fields: list[dict[str, Any]], arguments: list[Any]) -> Any:
    """Sets fields to literals, and to arguments of the action."""
    for each in fields:
        value = arguments[each["argument"]] if "argument" in each else each["value"]
        *before, last = _steps(each["path"])
        owner = message
        for step in before:
            owner = field(owner, str(step) if not isinstance(step, int) else f"[{step}]")
        if last == "stamp" or last not in getattr(owner, "__slots__", []):
            field(owner, str(last))
        setattr(owner, last, value)
    return message


def check(message: Any, fields: list[dict[str, Any]]) -> None:
    """Raises Unfit if a field does not exist or cannot have such a value."""
    for each in fields:
        sample = {**each, "value": _SAMPLES.get(each.get("type", ""), "x")} if "argument" in each else each
        sample.pop("argument", None)
        fill(message, [sample], [])
        try:
            message._check_types()
        except Exception as error:
            raise Unfit(f"field `{each['path']}` of `{_type_of(message)}`: {error}") from None
