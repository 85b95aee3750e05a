"""A user's function as the action of a skill."""

from __future__ import annotations

import enum
import inspect
import typing
from typing import Any, Callable

from proskill.stop import Stop


class Function:
    """A function and its signature."""

    def __init__(self, skill: str, call: Callable[..., Any]) -> None:
        self.skill = skill
        self.call = call
        self.is_async = inspect.iscoroutinefunction(call)
        self.signature = inspect.signature(call)
        try:
            self.types = typing.get_type_hints(call)
        except Exception:  # a name known to type checkers only
            self.types = {}
        self.stop = next((name for name in self.signature.parameters
                          if name == "stop" or self.types.get(name) is Stop), None)

    def bound(self, arguments: list[Any], stop: Stop) -> inspect.BoundArguments:
        """The arguments in order, with a `Stop` if it has a parameter for it. Raises TypeError."""
        rest = iter(arguments)
        given: list[Any] = []
        named: dict[str, Any] = {}
        for name, parameter in self.signature.parameters.items():
            if name == self.stop and parameter.kind is parameter.KEYWORD_ONLY:
                named[name] = stop
            elif name == self.stop:
                given.append(stop)
            elif parameter.kind is parameter.VAR_POSITIONAL:
                given.extend(rest)
            else:
                given.extend([value for value in [next(rest, _MISSING)] if value is not _MISSING])
        return self.signature.bind(*given, *rest, **named)

    def wrong_results(self, results: list[str]) -> list[str]:
        """Declared return values that are not results of the skill."""
        returned = self.types.get("return")
        if inspect.isclass(returned) and issubclass(returned, enum.Enum):
            return [str(member.value) for member in returned if member.value not in results]
        if typing.get_origin(returned) is typing.Literal:
            return [str(value) for value in typing.get_args(returned) if value not in results]
        return []


_MISSING = object()


def result_name(returned: Any) -> str | None:
    """The protocol's name of a returned value; None if nothing was returned."""
    value = returned.value if isinstance(returned, enum.Enum) else returned
    if value is None or isinstance(value, str):
        return value
    raise TypeError(f"the action returned {returned!r}, which is not the name of a result")
