"""The model of a goal, examples/ros2/goal.fcr, is that of the adapter's table, and the verifier proves it. Clients that
cancel carelessly are found.

usage: model.py PROGRAM
"""

import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(ROOT / "python"), str(ROOT / "tests/ros")]
import goal_models  # noqa: E402
from proskill.ros2.goal import TABLE, Input, Output, State  # noqa: E402
from proskill.ros2.model import client  # noqa: E402

MODEL = (ROOT / "examples/ros2/goal.fcr").read_text(encoding="utf-8")
ORPHAN, STOPS, PROMPT, NOTICED = "no_orphan", "stops", "prompt", "noticed"
# One change each: what a careless client does, and the property that finds it.
CARELESS = [
    (State.SENT, Input.STOP, (Output.END_STOPPED, State.ENDED), ORPHAN),  # nothing was accepted yet
    (State.SENT, Input.STOP, (Output.SEND_CANCEL, State.ENDED), ORPHAN),  # the cancel will arrive
    (State.SENT, Input.STOP, (Output.SEND_CANCEL, State.STOPPING), ORPHAN),  # "unknown goal", says the server
    (State.WITHDRAWING, Input.ACCEPTED, (Output.SEND_CANCEL, State.ENDED), ORPHAN),  # the server will obey
    (State.WITHDRAWING, Input.LISTED, (Output.NOTHING, State.WITHDRAWING), PROMPT),  # its answer is lost
    (State.STOPPING, Input.IMPATIENCE, (Output.NOTHING, State.STOPPING), STOPS),  # the server refused the cancel
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
        self.assertEqual((marks, code), (list("✓✓✓✓✗✓"), 1))  # the fifth: a goal can succeed

    def test_careless_clients_are_found(self):
        self.finds_each(CARELESS)

    def test_a_client_that_waits_for_a_lost_result_is_found(self):
        waits = (Output.NOTHING, State.RUNNING)
        self.finds({(State.RUNNING, Input.OVER): waits, (State.RUNNING, Input.FORGOTTEN): waits}, NOTICED)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
