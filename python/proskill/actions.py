"""The actions of a program as functions."""

from __future__ import annotations

import asyncio
import sys
import threading
import traceback
from typing import Any, Callable, TypeVar, overload

from proskill.connection import PROTOCOL, Connection
from proskill.function import Function, result_name
from proskill.stop import Stop, Stopped

Call = TypeVar("Call", bound=Callable[..., Any])

_PATIENCE = 4.0  # seconds that actions have to stop at the end; `proskill run` waits for five


class _Run:
    """A run of an action, from its start to its end."""

    def __init__(self, number: int, stop: Stop) -> None:
        self.number = number
        self.stop = stop
        self.abandoned = False
        self.task: asyncio.Task[Any] | None = None  # for async functions without a token parameter


class Platform:
    """Performs the actions of a program and reports events to it."""

    def __init__(self) -> None:
        self._functions: dict[str, Function] = {}
        self._background: list[Function] = []
        self._runs: dict[int, _Run] = {}
        self._changed = threading.Condition()
        self._connection: Connection | None = None
        self._early: list[tuple[str, dict[str, Any]]] = []
        self._ready = False
        self._results: dict[str, list[str]] = {}
        self._end = Stop()
        self._loop: asyncio.AbstractEventLoop | None = None
        self.speed = 1.0  # of the run's clock

    # --- For users

    @overload
    def action(self, skill: Call) -> Call: ...
    @overload
    def action(self, skill: str) -> Callable[[Call], Call]: ...
    def action(self, skill: Any) -> Any:
        """Makes a function the action of the named skill, or of the skill with its own name.

        The function receives the arguments of `:action` in order, and a `Stop` for a parameter
        that is called `stop` or has this type. It returns the name of a result, or a member of an
        enumeration with this value. An exception ends the skill without a result. Each run has a
        thread of its own. An `async` function runs in an event loop; if it has no `Stop`, it is
        cancelled when it is asked to stop."""
        if isinstance(skill, str):
            return lambda call: self._add(skill, call)
        return self._add(skill.__name__, skill)

    def background(self, call: Call) -> Call:
        """Runs a function during the whole run, with a `Stop` if it has a parameter for it."""
        self._background.append(Function(call.__name__, call))
        return call

    def report(self, event: str) -> None:
        """Reports an event of the program."""
        self._send("event", name=event)

    def interrupt(self, skill: str) -> None:
        """Interrupts a skill."""
        self._send("interrupt", skill=skill)

    def log(self, text: str) -> None:
        """Writes a line to the recording."""
        self._send("log", text=text)

    def run(self, connection: Connection | None = None) -> None:
        """Performs actions until the run or `proskill run` ends, then stops all of them."""
        self._connection = connection or Connection.of_this_process()
        try:
            for message in self._connection.messages():
                if message.get("type") == "end" or not self._obey(message):
                    break
        finally:
            self._stop_all()

    # --- Messages of `proskill run`

    def _obey(self, message: dict[str, Any]) -> bool:
        kind = message.get("type")
        if kind == "hello":
            return self._greet(message)
        if kind == "start":
            self._start(message)
        run = self._runs.get(message.get("run", 0))
        if kind in ("stop", "abandon") and run:
            run.abandoned = kind == "abandon"
            self._ask_to_stop(run)
        return True

    def _greet(self, hello: dict[str, Any]) -> bool:
        why = self._why_not(hello)
        if why:
            self._connected.send("failed", text=why)
            return False
        self.speed = float(hello["speed"])
        self._connected.send("ready", protocol=PROTOCOL)
        with self._changed:
            self._ready = True
            early, self._early = self._early, []
        for kind, members in early:
            self._connected.send(kind, **members)
        self._end = Stop(self.speed)
        for function in self._background:
            threading.Thread(target=self._watch, args=(function,), daemon=True).start()
        return True

    def _why_not(self, hello: dict[str, Any]) -> str:
        """Why this platform does not fit the program; empty if it does."""
        if hello.get("protocol") != PROTOCOL:
            return f"this package speaks version {PROTOCOL} of the protocol"
        self._results = {skill["name"]: [result["name"] for result in skill["results"]]
                         for skill in hello["skills"]}
        missing = [f"`{name}`" for name in self._results if name not in self._functions]
        if missing:
            return f"no function for {', '.join(missing)}"
        for name, function in self._functions.items():
            wrong = function.wrong_results(self._results.get(name, []))
            if name in self._results and wrong:
                return f"`{name}` has no result `{wrong[0]}`"
        return ""

    def _start(self, message: dict[str, Any]) -> None:
        run = _Run(message["run"], Stop(self.speed))
        with self._changed:
            self._runs[run.number] = run
        function = self._functions[message["skill"]]
        arguments = message["arguments"]
        if not function.is_async:
            threading.Thread(target=self._perform, args=(run, function, arguments),
                             name=f"{function.skill} {run.number}", daemon=True).start()
            return
        asyncio.run_coroutine_threadsafe(self._perform_async(run, function, arguments),
                                         self._event_loop())

    def _ask_to_stop(self, run: _Run) -> None:
        run.stop.request()
        if run.task:
            self._event_loop().call_soon_threadsafe(run.task.cancel)

    # --- Performing

    def _perform(self, run: _Run, function: Function, arguments: list[Any]) -> None:
        try:
            bound = function.bound(arguments, run.stop)
            self._finish(run, function, function.call(*bound.args, **bound.kwargs))
        except BaseException as error:
            self._fail(run, error)

    async def _perform_async(self, run: _Run, function: Function, arguments: list[Any]) -> None:
        try:
            bound = function.bound(arguments, run.stop)
            task = asyncio.ensure_future(function.call(*bound.args, **bound.kwargs))
            if not function.stop:
                run.task = task
                if run.stop.requested:  # it may have come before the task existed
                    task.cancel()
            self._finish(run, function, await task)
        except BaseException as error:
            self._fail(run, error)

    def _finish(self, run: _Run, function: Function, returned: Any) -> None:
        name = result_name(returned)
        if name is None and run.stop.requested:
            self._say_end(run, "stopped")
        elif name is None and "success" not in self._results[function.skill]:
            raise TypeError("the action returned nothing, but its skill has results with names")
        else:
            self._say_end(run, "result", result=name or "success")

    def _fail(self, run: _Run, error: BaseException) -> None:
        if run.stop.requested and isinstance(error, (Stopped, asyncio.CancelledError)):
            self._say_end(run, "stopped")
            return
        traceback.print_exception(type(error), error, error.__traceback__)
        self._say_end(run, "failed", text=f"{type(error).__name__}: {error}")

    def _say_end(self, run: _Run, kind: str, **members: Any) -> None:
        with self._changed:
            self._runs.pop(run.number, None)
            self._changed.notify_all()
        if not run.abandoned:
            self._connected.send(kind, run=run.number, **members)

    def _watch(self, function: Function) -> None:
        try:
            function.call(*([self._end] if function.stop else []))
        except Stopped:
            pass
        except Exception as error:
            traceback.print_exc()
            self.log(f"{function.skill} ended: {type(error).__name__}: {error}")

    # --- Sending

    def _add(self, skill: str, call: Call) -> Call:
        if skill in self._functions:
            raise ValueError(f"`{skill}` has a function already")
        self._functions[skill] = Function(skill, call)
        return call

    def _send(self, kind: str, **members: Any) -> None:
        with self._changed:
            if not self._ready:
                self._early.append((kind, members))
                return
        self._connected.send(kind, **members)

    def _stop_all(self) -> None:
        self._end.request()
        with self._changed:
            for run in list(self._runs.values()):
                self._ask_to_stop(run)
            if not self._changed.wait_for(lambda: not self._runs, _PATIENCE):
                names = ", ".join(str(run) for run in self._runs)
                print(f"runs that did not stop: {names}", file=sys.stderr)
        if self._loop:
            self._loop.call_soon_threadsafe(self._loop.stop)

    def _event_loop(self) -> asyncio.AbstractEventLoop:
        if not self._loop:
            self._loop = asyncio.new_event_loop()
            threading.Thread(target=self._loop.run_forever, daemon=True).start()
        return self._loop

    @property
    def _connected(self) -> Connection:
        assert self._connection is not None
        return self._connection
