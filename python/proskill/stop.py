"""How an action learns that it is to stop."""

from __future__ import annotations

import threading


class Stopped(Exception):
    """Raised in an action that was asked to stop. An action that lets it pass has stopped."""


class Stop:
    """Asked to stop, or not yet: each run of an action has its own."""

    def __init__(self, speed: float = 1.0) -> None:
        self._event = threading.Event()
        self._speed = speed

    @property
    def requested(self) -> bool:
        """Whether the action is to stop."""
        return self._event.is_set()

    def check(self) -> None:
        """Raises Stopped if the action is to stop."""
        if self.requested:
            raise Stopped

    def wait(self, seconds: float | None = None) -> bool:
        """Waits until the action is to stop, at most so many seconds of the run's clock.

        True where it is to stop."""
        return self._event.wait(None if seconds is None else max(seconds, 0.0) / self._speed)

    def sleep(self, seconds: float) -> None:
        """Waits so many seconds of the run's clock; raises Stopped if the action is to stop."""
        if self.wait(seconds):
            raise Stopped

    def request(self) -> None:
        """Asks for the stop. `proskill run` does it; tests of an action may."""
        self._event.set()
