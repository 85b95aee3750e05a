"""The model of a goal, examples/ros1/goal.fcr, is that of the adapter's table, and the verifier proves it. Clients that
cancel carelessly are found.

usage: model.py PROGRAM
"""

import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(ROOT / "python"), str(ROOT / "tests/ros")]
import goal_models  # noqa: E402
from proskill.ros1.goal import TABLE, Input, Output, State  # noqa: E402
from proskill.ros1.model import client  # noqa: E402
from proskill.ros.sensing import Sensor  # noqa: E402

MODEL = (ROOT / "examples/ros1/goal.fcr").read_text(encoding="utf-8")
ORPHAN, STOPS = "no_orphan", "stops"
# One change each: what a careless client does, and the property that finds it.
CARELESS = [
    (State.SENT, Input.STOP, (Output.END_STOPPED, State.ENDED), ORPHAN),  # nothing to cancel yet
    (State.SENT, Input.STOP, (Output.SEND_CANCEL, State.ENDED), ORPHAN),  # the cancel will arrive
    (State.WITHDRAWING, Input.UNLISTED, (Output.END_STOPPED, State.ENDED), ORPHAN),  # it never arrived
    (State.STOPPING, Input.UNLISTED, (Output.NOTHING, State.STOPPING), STOPS),  # it waits for a result that is gone
    (State.STOPPING, Input.SERVER_DEAD, (Output.NOTHING, State.STOPPING), STOPS),  # it waits for a dead server
]


class Model(goal_models.Model):
    model = MODEL
    table = TABLE
    client = staticmethod(client)

    def test_the_model_has_the_states_and_steps_that_are_executed(self):
        self.has_its_table()

    def test_no_goal_runs_after_its_skill_and_what_is_to_stop_stops(self):
        marks, code = self.verify(MODEL)
        self.assertEqual((marks, code), (list("✓✓✓✗✓✓"), 1))  # the fourth: a goal can succeed

    def test_careless_clients_are_found(self):
        self.finds_each(CARELESS)


class Sensors(unittest.TestCase):
    def test_a_value_is_left_beyond_its_hysteresis(self):
        sensor = Sensor([{"below": 0.2, "event": "critical"}, {"event": "good"}], hysteresis=0.1)
        self.assertEqual([sensor.take(value, 0) for value in (0.25, 0.19, 0.29, 0.31, 0.25)],
                         ["good", "critical", None, "good", None])

    def test_silence_is_reported_once_and_what_is_no_number_is_silence(self):
        sensor = Sensor([{"event": "good"}], timeout=2, silent="silent")
        sensor.begin(10)
        self.assertEqual(sensor.take(1.0, 11), "good")
        self.assertEqual(sensor.take(float("nan"), 12.5), None)
        self.assertEqual([sensor.silence(now) for now in (12.9, 13.0, 14.0)], [None, "silent", None])
        self.assertEqual(sensor.take(1.0, 15), "good")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
