"""The client of examples/ros2/goal.fcr, printed from the table that the adapter executes.

    python3 -m proskill.ros2.model
"""

from __future__ import annotations

from proskill.ros2.goal import TABLE, Input, Output, State
from proskill.ros.table import Process, Table

_ENDS = (Output.END_RESULT, Output.END_BARE, Output.END_REJECTED, Output.END_STOPPED, Output.END_FAILED)
_PROCESS = Process(
    State, Input, "&goal_sent: bool, &cancels: cancel_line, &asked: bool",
    {
        Output.NOTHING: [],
        Output.SEND_GOAL: ["goal_sent := true"],
        Output.SEND_CANCEL: ["if not full cancels then cancels := enqueue(cancels, true) end"],
        Output.ASK_RESULT: ["asked := true"],
        Output.CANCEL_AND_ASK: ["if not full cancels then cancels := enqueue(cancels, true) end", "asked := true"],
        **{end: [] for end in _ENDS},
    },
    (Input.SERVER_READY, Input.STOP, Input.SERVER_DEAD, Input.IMPATIENCE))


def client(table: Table = TABLE) -> str:
    """The process `client`."""
    return _PROCESS.text(table)


if __name__ == "__main__":
    print(client(), end="")
