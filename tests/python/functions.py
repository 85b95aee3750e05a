"""Functions as actions, with a test at the other end of the connection.

usage: functions.py
"""

import asyncio
import enum
import json
import os
import pathlib
import sys
import threading
import unittest
from typing import Literal

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from proskill import Platform, Stop, Stopped  # noqa: E402
from proskill.connection import Connection  # noqa: E402

HELLO = {"type": "hello", "protocol": 1, "mission": "mission", "speed": 1000.0,
         "skills": [{"name": "fly", "results": [{"name": "there", "status": "success"},
                                                {"name": "lost", "status": "failure"}]}],
         "events": ["storm"], "interrupts": ["fly"]}
PLAIN = {"name": "fly", "results": [{"name": "success", "status": "success"}]}


class Talk:
    """A running platform, and its messages. `with` ends it."""

    def __init__(self, platform, **hello):
        to_read, to_write = os.pipe()
        from_read, from_write = os.pipe()
        self.out = os.fdopen(to_write, "wb", buffering=0)
        self.lines = os.fdopen(from_read, "rb")
        connection = Connection(os.fdopen(to_read, "rb"), os.fdopen(from_write, "wb", buffering=0))
        self.thread = threading.Thread(target=platform.run, args=(connection,), daemon=True)
        self.thread.start()
        self.say({**HELLO, **hello})

    def say(self, message):
        self.out.write(json.dumps(message).encode() + b"\n")

    def start(self, *arguments, run=1):
        self.say({"type": "start", "run": run, "skill": "fly", "command": "fly",
                  "arguments": list(arguments), "time": 0})

    def hear(self):
        return json.loads(self.lines.readline())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.out.close()
        self.thread.join(60)
        self.lines.close()
        assert not self.thread.is_alive()


def performing(function, **hello):
    platform = Platform()
    platform.action("fly")(function)
    talk = Talk(platform, **hello)
    assert talk.hear() == {"type": "ready", "protocol": 1}
    return talk


class Actions(unittest.TestCase):
    def ends(self, function, *arguments, **hello):
        """The messages on a run of this function, without its number."""
        with performing(function, **hello) as talk:
            talk.start(*arguments)
            said = talk.hear()
        self.assertEqual(said.pop("run"), 1)
        return said

    def test_the_name_of_a_result_is_the_result(self):
        self.assertEqual(self.ends(lambda: "there"), {"type": "result", "result": "there"})

    def test_a_member_of_an_enumeration_is_its_value(self):
        class Fly(enum.Enum):
            LOST = "lost"
        self.assertEqual(self.ends(lambda: Fly.LOST), {"type": "result", "result": "lost"})

    def test_nothing_is_the_success_without_a_tag(self):
        self.assertEqual(self.ends(lambda: None, skills=[PLAIN]), {"type": "result", "result": "success"})
        said = self.ends(lambda: None)
        self.assertEqual(said["type"], "failed")
        self.assertIn("returned nothing", said["text"])

    def test_what_is_no_name_is_a_failure(self):
        said = self.ends(lambda: 3)
        self.assertEqual(said["text"], "TypeError: the action returned 3, which is not the name of a result")

    def test_an_exception_is_a_failure(self):
        def throws():
            raise ValueError("no wings")
        self.assertEqual(self.ends(throws), {"type": "failed", "text": "ValueError: no wings"})
        self.assertEqual(self.ends(lambda: sys.exit(3)), {"type": "failed", "text": "SystemExit: 3"})

        def not_asked():
            raise Stopped
        self.assertEqual(self.ends(not_asked), {"type": "failed", "text": "Stopped: "})

    def test_arguments_come_in_order_and_the_token_where_it_is_named(self):
        seen = []

        def fly(height, halt: Stop, where="here", *more):
            seen.extend([height, isinstance(halt, Stop), where, more])
            return "there"
        self.ends(fly, 3, "dock", True, None)
        self.assertEqual(seen, [3, True, "dock", (True, None)])

        def keyword(height, *, stop):
            seen[:] = [height, isinstance(stop, Stop)]
            return "there"
        self.ends(keyword, 1.5)
        self.assertEqual(seen, [1.5, True])

    def test_too_few_and_too_many_arguments_are_failures(self):
        self.assertIn("missing a required argument: 'height'", self.ends(lambda height: "there")["text"])
        self.assertIn("too many positional arguments", self.ends(lambda: "there", 1)["text"])

    def test_an_async_function_is_awaited(self):
        async def fly(height):
            await asyncio.sleep(0)
            return "there" if height == 3 else "lost"
        self.assertEqual(self.ends(fly, 3), {"type": "result", "result": "there"})

    def test_runs_go_on_side_by_side(self):
        both = threading.Barrier(2)

        def fly():
            both.wait(60)
            return "there"
        with performing(fly) as talk:
            talk.start(run=1)
            talk.start(run=2)
            self.assertEqual({talk.hear()["run"], talk.hear()["run"]}, {1, 2})


class Stops(unittest.TestCase):
    def stopped(self, function):
        with performing(function) as talk:
            talk.start()
            talk.say({"type": "stop", "run": 1})
            return talk.hear()

    def test_a_wait_ends_with_the_stop(self):
        def fly(stop):
            stop.sleep(1e9)
        self.assertEqual(self.stopped(fly), {"type": "stopped", "run": 1})

        def polls(stop):
            while not stop.requested:
                stop.wait(0.01)
        self.assertEqual(self.stopped(polls), {"type": "stopped", "run": 1})

        def checks(stop):
            stop.wait()
            stop.check()
        self.assertEqual(self.stopped(checks), {"type": "stopped", "run": 1})

    def test_a_result_may_come_all_the_same(self):
        def fly(stop):
            stop.wait()
            return "there"
        self.assertEqual(self.stopped(fly), {"type": "result", "run": 1, "result": "there"})

    def test_an_async_function_is_cancelled_wherever_it_is(self):
        async def fly():
            await asyncio.sleep(1e6)
        for _ in range(50):
            self.assertEqual(self.stopped(fly), {"type": "stopped", "run": 1})

    def test_an_async_function_with_a_token_is_not_cancelled(self):
        async def fly(stop):
            while not stop.requested:
                await asyncio.sleep(0)
            return "lost"
        self.assertEqual(self.stopped(fly), {"type": "result", "run": 1, "result": "lost"})

    def test_the_end_of_the_input_stops_all(self):
        over = []

        def fly(stop):
            over.append(stop.wait(1e9))
            return "there"
        with performing(fly) as talk:
            talk.start()
            talk.start(run=2)
        self.assertEqual(over, [True, True])

    def test_of_an_abandoned_run_nothing_is_said(self):
        goes_on = threading.Event()

        def fly(stop):
            if stop.wait(0):
                return "there"
            goes_on.wait(60)
            return "lost"
        with performing(fly) as talk:
            talk.start()
            talk.say({"type": "stop", "run": 1})
            talk.say({"type": "abandon", "run": 1})
            talk.start(run=2)
            goes_on.set()
            said = [talk.hear()]
            while said[-1]["run"] != 2:
                said.append(talk.hear())
        self.assertEqual(said[-1], {"type": "result", "run": 2, "result": "lost"})


class Greeting(unittest.TestCase):
    def refused(self, platform, **hello):
        with Talk(platform, **hello) as talk:
            said = talk.hear()
        self.assertEqual(said["type"], "failed")
        return said["text"]

    def test_each_skill_needs_a_function(self):
        self.assertEqual(self.refused(Platform()), "no function for `fly`")

    def test_what_a_function_says_it_returns_is_a_result(self):
        platform = Platform()

        @platform.action
        def fly() -> Literal["there", "lots"]:
            return "there"
        self.assertEqual(self.refused(platform), "`fly` has no result `lots`")

        class Fly(enum.Enum):
            GONE = "gone"
        other = Platform()

        @other.action("fly")
        def fly_away() -> Fly:
            return Fly.GONE
        self.assertEqual(self.refused(other), "`fly` has no result `gone`")

    def test_another_version_is_refused(self):
        self.assertEqual(self.refused(Platform(), protocol=2), "this package speaks version 1 of the protocol")

    def test_a_skill_has_one_function(self):
        platform = Platform()
        platform.action("fly")(lambda: "there")
        with self.assertRaises(ValueError):
            platform.action("fly")(lambda: "lost")

    def test_what_is_reported_before_waits_for_the_greeting(self):
        platform = Platform()
        platform.action("fly")(lambda: "there")
        platform.report("storm")
        platform.interrupt("fly")
        platform.log("hello")
        with Talk(platform) as talk:
            said = [talk.hear() for _ in range(4)]
        self.assertEqual(said, [{"type": "ready", "protocol": 1}, {"type": "event", "name": "storm"},
                                {"type": "interrupt", "skill": "fly"}, {"type": "log", "text": "hello"}])

    def test_a_function_in_the_background_begins_with_the_run_and_ends_with_it(self):
        platform = Platform()
        platform.action("fly")(lambda: "there")
        over = threading.Event()

        @platform.background
        def watch(stop):
            platform.report("storm")
            stop.wait()
            over.set()

        @platform.background
        def throws():
            raise ValueError("no sensor")
        with Talk(platform) as talk:
            said = [talk.hear() for _ in range(3)]
        self.assertIn({"type": "event", "name": "storm"}, said)
        self.assertIn({"type": "log", "text": "throws ended: ValueError: no sensor"}, said)
        self.assertTrue(over.wait(60))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], warnings="ignore")
