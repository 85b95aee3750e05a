"""From values to events: cases with conditions, hysteresis, silence. Nothing here needs ROS."""

from __future__ import annotations

import math
from typing import Any


def holds(case: dict[str, Any], value: Any, slack: float = 0.0) -> bool:
    """Whether a value is one of the case's, or within this distance of them."""
    if "below" in case and not value < case["below"] + slack:
        return False
    if "above" in case and not value > case["above"] - slack:
        return False
    return "equals" not in case or value == case["equals"]


def is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


class Sensor:
    """What the values of a field mean: the first of the cases whose condition holds."""

    def __init__(self, cases: list[dict[str, Any]], hysteresis: float = 0.0,
                 timeout: float | None = None, silent: str | None = None) -> None:
        self._cases = cases
        self._hysteresis = hysteresis
        self._timeout = timeout
        self._silent = silent
        self._present: int | None = None
        self._is_silent = False
        self._heard: float | None = None

    def begin(self, now: float) -> None:
        """Silence is measured from here."""
        self._heard = now

    def take(self, value: Any, now: float) -> str | None:
        """The event that a value causes. A value that is not a number (NaN) is none."""
        if isinstance(value, float) and math.isnan(value):
            return None
        self._heard = now
        found = self._case_of(value)
        if found == self._present and not self._is_silent:
            return None
        self._present, self._is_silent = found, False
        return None if found is None else self._cases[found].get("event")

    def silence(self, now: float) -> str | None:
        """The event that the time without a message causes."""
        if self._timeout is None or self._heard is None or self._is_silent:
            return None
        if now - self._heard < self._timeout:
            return None
        self._present, self._is_silent = None, True
        return self._silent

    def _case_of(self, value: Any) -> int | None:
        for index, case in enumerate(self._cases):
            slack = self._hysteresis if index == self._present else 0.0
            if holds(case, value, slack):
                return index
        return None
