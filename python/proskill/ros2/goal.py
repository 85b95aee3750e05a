"""One goal on an action server of ROS 2: what is sent and reported in which state.

The table is the whole protocol. `model.py` prints it as a process in Fiacre, and
examples/ros2/goal.fcr verifies it with the network and the server around it: no goal runs after
its skill has ended.
"""

from __future__ import annotations

import enum

from proskill.ros.table import Table


class State(enum.Enum):
    WAITING = "waiting"  # for the server; nothing has been sent
    SENT = "sent"  # the server has not answered
    WITHDRAWING = "withdrawing"  # likewise; to be cancelled as soon as it is accepted
    RUNNING = "running"  # accepted; the result has been asked for
    STOPPING = "stopping"  # to be cancelled
    FINISHED = "finished"  # the server has ended it; the result is to come
    ASKING_AGAIN = "asking_again"  # likewise; it has been asked for again
    ENDED = "ended"  # reported


class Input(enum.Enum):
    SERVER_READY = "server_ready"  # its three services and two topics are there
    STOP = "stop"  # the skill is interrupted
    ACCEPTED = "accepted"  # the server's answer to the goal
    REJECTED = "rejected"
    LISTED = "listed"  # the server's status contains the goal: accepted, executing
    CANCELLING = "cancelling"  # likewise: canceling; or the answer to a cancel
    OVER = "over"  # likewise: it has a terminal state
    FORGOTTEN = "forgotten"  # the server that had accepted it does not know it any more
    RESULT = "result"  # the answer with the result
    SERVER_DEAD = "server_dead"  # its participant has left, or has been silent for its lease
    IMPATIENCE = "impatience"  # time has passed in a state that waits


class Output(enum.Enum):
    SEND_GOAL = "send_goal"
    SEND_CANCEL = "send_cancel"
    ASK_RESULT = "ask_result"
    CANCEL_AND_ASK = "cancel_and_ask"  # some servers end a goal when its result is asked for
    END_RESULT = "end_result"  # the action has ended with a result
    END_BARE = "end_bare"  # it has ended, and at most its terminal state is known
    END_REJECTED = "end_rejected"
    END_STOPPED = "end_stopped"
    END_FAILED = "end_failed"
    NOTHING = "nothing"


_STOPPED = (Output.END_STOPPED, State.ENDED)
_FAILED = (Output.END_FAILED, State.ENDED)
_RESULT = (Output.END_RESULT, State.ENDED)
_BARE = (Output.END_BARE, State.ENDED)
_CANCEL = (Output.SEND_CANCEL, State.STOPPING)
_CANCEL_AND_ASK = (Output.CANCEL_AND_ASK, State.STOPPING)
_RUN = (Output.ASK_RESULT, State.RUNNING)

# An input that a state does not name changes nothing.
TABLE: Table = {
    State.WAITING: {
        Input.SERVER_READY: (Output.SEND_GOAL, State.SENT),
        Input.STOP: _STOPPED,
        Input.IMPATIENCE: _FAILED,
    },
    # The answer may be lost: the status says the same.
    State.SENT: {
        Input.STOP: (Output.NOTHING, State.WITHDRAWING),
        Input.ACCEPTED: _RUN,
        Input.REJECTED: (Output.END_REJECTED, State.ENDED),
        Input.LISTED: _RUN,
        Input.CANCELLING: _RUN,  # by another client
        Input.OVER: (Output.ASK_RESULT, State.FINISHED),
        Input.SERVER_DEAD: _FAILED,
    },
    # A cancel now would be answered with "unknown goal", and the goal accepted afterwards.
    State.WITHDRAWING: {
        Input.ACCEPTED: _CANCEL_AND_ASK,
        Input.REJECTED: _STOPPED,
        Input.LISTED: _CANCEL_AND_ASK,
        Input.CANCELLING: (Output.ASK_RESULT, State.STOPPING),
        Input.OVER: _STOPPED,
        Input.SERVER_DEAD: _STOPPED,
    },
    State.RUNNING: {
        Input.STOP: _CANCEL,
        Input.OVER: (Output.NOTHING, State.FINISHED),
        Input.FORGOTTEN: _BARE,
        Input.RESULT: _RESULT,
        Input.SERVER_DEAD: _FAILED,
    },
    # A server may refuse a cancel, so it is repeated.
    State.STOPPING: {
        Input.OVER: _STOPPED,
        Input.FORGOTTEN: _STOPPED,
        Input.RESULT: _STOPPED,
        Input.SERVER_DEAD: _STOPPED,
        Input.IMPATIENCE: _CANCEL,
    },
    State.FINISHED: {
        Input.STOP: _STOPPED,
        Input.FORGOTTEN: _BARE,
        Input.RESULT: _RESULT,
        Input.SERVER_DEAD: _BARE,
        Input.IMPATIENCE: (Output.ASK_RESULT, State.ASKING_AGAIN),
    },
    State.ASKING_AGAIN: {
        Input.STOP: _STOPPED,
        Input.FORGOTTEN: _BARE,
        Input.RESULT: _RESULT,
        Input.SERVER_DEAD: _BARE,
        Input.IMPATIENCE: _BARE,
    },
    # Whatever happens, a goal of ours without a skill is cancelled.
    State.ENDED: {
        Input.ACCEPTED: (Output.SEND_CANCEL, State.ENDED),
        Input.LISTED: (Output.SEND_CANCEL, State.ENDED),
    },
}


def reply(state: State, given: Input, table: Table = TABLE) -> tuple[Output, State]:
    """What is done for an input, and the next state."""
    return table[state].get(given, (Output.NOTHING, state))  # type: ignore[return-value]
