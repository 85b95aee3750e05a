"""One goal on an action server: what is sent and reported in which state.

The table is the whole protocol. `model.py` prints it as a process in Fiacre, and
examples/ros1/goal.fcr verifies it with the network and the server around it: no goal runs after
its skill has ended.
"""

from __future__ import annotations

import enum

from proskill.ros.table import Table


class State(enum.Enum):
    WAITING = "waiting"  # for the server; nothing has been sent
    SENT = "sent"  # the server has not mentioned the goal
    ACCEPTED = "accepted"  # the server has the goal
    WITHDRAWING = "withdrawing"  # to be cancelled, and the server has not mentioned it
    STOPPING = "stopping"  # to be cancelled, and the server has it
    RECALLING = "recalling"  # the server knows the cancel, and perhaps not the goal yet
    FINISHED = "finished"  # the server has ended it; the result is to come
    ENDED = "ended"  # reported


class Input(enum.Enum):
    SERVER_READY = "server_ready"  # all five topics are connected
    STOP = "stop"  # the skill is interrupted
    UNLISTED = "unlisted"  # the server's status does not contain the goal
    LISTED = "listed"  # it is pending or active
    CANCELLING = "cancelling"  # it is recalling or preempting
    OVER = "over"  # it has a terminal state
    RESULT = "result"  # the message with the result
    SERVER_DEAD = "server_dead"  # the server's process does not exist any more
    IMPATIENCE = "impatience"  # time has passed in a state that waits


class Output(enum.Enum):
    NOTHING = "nothing"
    SEND_GOAL = "send_goal"
    SEND_CANCEL = "send_cancel"
    END_RESULT = "end_result"  # the action has ended with a result
    END_BARE = "end_bare"  # it has ended, and only its terminal state is known
    END_STOPPED = "end_stopped"
    END_FAILED = "end_failed"


_STOPPED = (Output.END_STOPPED, State.ENDED)
_FAILED = (Output.END_FAILED, State.ENDED)
_RESULT = (Output.END_RESULT, State.ENDED)

# An input that a state does not name changes nothing.
TABLE: Table = {
    State.WAITING: {
        Input.SERVER_READY: (Output.SEND_GOAL, State.SENT),
        Input.STOP: _STOPPED,
        Input.IMPATIENCE: _FAILED,
    },
    State.SENT: {
        Input.STOP: (Output.SEND_CANCEL, State.WITHDRAWING),
        Input.LISTED: (Output.NOTHING, State.ACCEPTED),
        Input.CANCELLING: (Output.NOTHING, State.ACCEPTED),  # by another client
        Input.OVER: (Output.NOTHING, State.FINISHED),
        Input.RESULT: _RESULT,
        Input.SERVER_DEAD: _FAILED,
    },
    State.ACCEPTED: {
        Input.STOP: (Output.SEND_CANCEL, State.STOPPING),
        Input.UNLISTED: _FAILED,  # forgotten, so it does not run
        Input.OVER: (Output.NOTHING, State.FINISHED),
        Input.RESULT: _RESULT,
        Input.SERVER_DEAD: _FAILED,
    },
    # Cancels are sent again and again: one may arrive before its goal, or be lost.
    State.WITHDRAWING: {
        Input.UNLISTED: (Output.SEND_CANCEL, State.WITHDRAWING),
        Input.LISTED: (Output.SEND_CANCEL, State.STOPPING),
        Input.CANCELLING: (Output.NOTHING, State.RECALLING),
        Input.OVER: _STOPPED,
        Input.RESULT: _STOPPED,
        Input.SERVER_DEAD: _STOPPED,
    },
    State.STOPPING: {
        Input.UNLISTED: _STOPPED,
        Input.LISTED: (Output.SEND_CANCEL, State.STOPPING),
        Input.OVER: _STOPPED,
        Input.RESULT: _STOPPED,
        Input.SERVER_DEAD: _STOPPED,
    },
    # A server keeps the cancel of a goal that it does not know for five seconds. A goal that did
    # not come meanwhile was lost with its connection.
    State.RECALLING: {
        Input.UNLISTED: _STOPPED,
        Input.LISTED: (Output.SEND_CANCEL, State.STOPPING),
        Input.OVER: _STOPPED,
        Input.RESULT: _STOPPED,
        Input.SERVER_DEAD: _STOPPED,
    },
    State.FINISHED: {
        Input.STOP: _STOPPED,
        Input.RESULT: _RESULT,
        Input.SERVER_DEAD: (Output.END_BARE, State.ENDED),
        Input.IMPATIENCE: (Output.END_BARE, State.ENDED),
    },
    # Whatever happens, a goal of ours without a skill is cancelled.
    State.ENDED: {
        Input.LISTED: (Output.SEND_CANCEL, State.ENDED),
    },
}


def reply(state: State, given: Input, table: Table = TABLE) -> tuple[Output, State]:
    """What is done for an input, and the next state."""
    return table[state].get(given, (Output.NOTHING, state))  # type: ignore[return-value]
