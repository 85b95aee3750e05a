"""Stop requests to actions."""

from __future__ import annotations

import threading


class Stopped(Exception):
    """Raised in an action that is asked to stop. Let it propagate to end the action."""


class Stop:
    """Stop request of one run of an action."""

    def __init__(self, speed: float = 1.0) -> None:
        self._event = threading.Event()
        self._speed = speed

    @property
    def requested(self) -> bool:
        """Whether the action is asked to stop."""
        return self._event.is_set()

    def check(self) -> None:
        """Raises Stopped if the action is asked to stop."""
        if self.requested:
            raise Stopped

    def wait(self, seconds: float | None = None) -> bool:
        """Waits until the action is asked to stop, at most this many seconds of the run's clock.

        Returns whether it is asked to stop."""
        return self._event.wait(None if seconds is None else max(seconds, 0.0) / self._speed)

    def sleep(self, seconds: float) -> None:
        """Waits this many seconds of the run's clock; raises Stopped if asked to stop."""
        if self.wait(seconds):
            raise Stopped

    def request(self) -> None:
        """Asks the action to stop. For tests of actions; otherwise `proskill run` does this."""
        self._event.set()
