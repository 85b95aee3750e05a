"""Messages that mappings fill and read."""

from __future__ import annotations

import struct
from typing import Any

from proskill.ros.adapter import Unfit
from proskill.ros2 import cdr
from proskill.ros2.cdr import Array, Struct, Type
from proskill.ros2.interfaces import set_field, type_of

# A value of each type of argument, to check mappings before the run begins.
_SAMPLES = {"float": 1.5, "int": 1, "nat": 1, "bool": True}


def filled(of: Struct, fields: list[dict[str, Any]], arguments: list[Any]) -> Any:
    """A message whose fields are literals, and arguments of the action."""
    message = cdr.initial(of)
    for each in fields:
        value = arguments[each["argument"]] if "argument" in each else each["value"]
        set_field(of, message, each["path"], _converted(type_of(of, each["path"]), value, each["path"]))
    return message


def _converted(of: Type, value: Any, path: str) -> Any:
    if value is None:
        raise Unfit(f"field `{path}`: the argument has no value")
    if isinstance(of, str) and of.startswith("float") and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    return value


def check(of: Struct, fields: list[dict[str, Any]]) -> None:
    """Raises Unfit if a field does not exist or cannot have such a value."""
    for each in fields:
        found = type_of(of, each["path"])
        value = _SAMPLES.get(each.get("type", ""), "x") if "argument" in each else each["value"]
        if not _fits(found, value):
            raise Unfit(f"field `{each['path']}` of type {name_of(found)} cannot be {value!r}")


def _fits(of: Type, value: Any) -> bool:
    if not isinstance(of, str) or isinstance(value, bool) != (of == "bool"):
        return False
    try:
        cdr.encode(of, value)
    except (struct.error, TypeError, ValueError, AttributeError):
        return False
    return True


def name_of(of: Type) -> str:
    if isinstance(of, Array):
        return f"{name_of(of.of)}[{of.count or ''}]"
    return of if isinstance(of, str) else "a message"


def is_numeric(of: Type) -> bool:
    return isinstance(of, str) and of not in ("bool", "string")
