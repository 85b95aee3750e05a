"""The client of examples/ros1/goal.fcr, printed from the table that the adapter executes.

    python3 -m proskill.ros1.model
"""

from __future__ import annotations

from proskill.ros1.goal import TABLE, Input, Output, State, Table, reply

# A client that does nothing with these does not take them; messages are always taken.
_NO_MESSAGES = (Input.SERVER_READY, Input.STOP, Input.SERVER_DEAD, Input.IMPATIENCE)
_EFFECTS = {
    Output.NOTHING: [],
    Output.SEND_GOAL: ["goal_sent := true"],
    Output.SEND_CANCEL: ["if not full cancels then cancels := enqueue(cancels, true) end"],
    Output.END_RESULT: ["skill_over := true"],
    Output.END_BARE: ["skill_over := true"],
    Output.END_STOPPED: ["skill_over := true"],
    Output.END_FAILED: ["skill_over := true"],
}


def client(table: Table = TABLE) -> str:
    """The process `client`."""
    ports = ", ".join(each.value for each in Input)
    states = ", ".join(each.value for each in State)
    parts = [f"process client\n    [{ports}: sync]\n"
             "    (&goal_sent: bool, &cancels: cancel_line, &skill_over: bool) is\n\n"
             f"states {states}"]
    parts += [_state(state, table) for state in State]
    return "\n\n".join(parts) + "\n"


def _state(state: State, table: Table) -> str:
    steps = [_step(state, given, table) for given in Input
             if given in table[state] or given not in _NO_MESSAGES]
    return f"from {state.value}\n    select\n        " + "\n    []  ".join(steps) + "\n    end"


def _step(state: State, given: Input, table: Table) -> str:
    output, following = reply(state, given, table)
    lines = [f"{given.value};", *(f"{effect};" for effect in _EFFECTS[output]),
             "loop" if following is state else f"to {following.value}"]
    return "\n        ".join(lines)


if __name__ == "__main__":
    print(client(), end="")
