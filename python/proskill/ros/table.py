"""The protocol of a goal as a table: what is done for an input in a state, and the next state. The adapter executes
it, and it is printed as a process in Fiacre, to be verified with the network and the server around it."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import Dict, Sequence, Tuple

Table = Dict[enum.Enum, Dict[enum.Enum, Tuple[enum.Enum, enum.Enum]]]


@dataclass(frozen=True)
class Process:
    """How a table is printed as the process `client`."""

    states: type[enum.Enum]
    inputs: type[enum.Enum]
    parameters: str  # what its effects change
    effects: dict[enum.Enum, list[str]]  # by output; of `nothing` as well
    # A client that does nothing with these does not take them; messages are always taken.
    no_messages: Sequence[enum.Enum]

    def text(self, table: Table) -> str:
        ports = ", ".join(each.value for each in self.inputs)
        states = ", ".join(each.value for each in self.states)
        parts = [f"process client\n    [{ports}: sync]\n    ({self.parameters}) is\n\nstates {states}"]
        parts += [self._state(state, table) for state in self.states]
        return "\n\n".join(parts) + "\n"

    def _state(self, state: enum.Enum, table: Table) -> str:
        steps = [self._step(state, given, table) for given in self.inputs
                 if given in table[state] or given not in self.no_messages]
        return f"from {state.value}\n    select\n        " + "\n    []  ".join(steps) + "\n    end"

    def _step(self, state: enum.Enum, given: enum.Enum, table: Table) -> str:
        output, following = table[state].get(given, (None, state))
        effects = self.effects[output] if output else []
        lines = [f"{given.value};", *(f"{effect};" for effect in effects),
                 "loop" if following is state else f"to {following.value}"]
        return "\n        ".join(lines)
