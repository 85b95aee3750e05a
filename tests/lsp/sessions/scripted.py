"""What scripted sessions share: the server, its answers, and running all sessions of a file."""

import os
import sys
import threading
import time

from client import Client, PATIENCE, position

PROGRAM = sys.argv[1]
LAMP = '(defsv lamp :states (On Off) :init Off)\n'
BAD = '(defsv lamp :states (On Off) :init Of)\n'
URI = 'file:///nowhere/lamp.proskill'


def server(**more):
    return Client([PROGRAM, 'lsp', '--debounce', '0', '--no-cache'], **more)


def started(**more):
    client = server(**more)
    client.initialize()
    return client


def codes(diagnostics):
    return [each['code'] for each in diagnostics]


def at(uri, line, character):
    return {'textDocument': {'uri': uri}, 'position': position(line, character)}


def is_running(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    with open(f'/proc/{process}/stat') as stat:
        return stat.read().rpartition(')')[2].split()[0] != 'Z'


def wait_until_gone(process):
    """By polling, since it is not our child."""
    deadline = time.monotonic() + PATIENCE
    while is_running(process):
        assert time.monotonic() < deadline, 'the server lives on'
        threading.Event().wait(0.01)


def run(sessions):
    """Runs the sessions of a module, given as its globals(): the functions that are its own. Those named on the command line
    alone, where there are any."""
    wanted = sys.argv[2:]
    for name, session in sessions.items():
        if not callable(session) or getattr(session, '__module__', '') != '__main__':
            continue
        if not wanted or name in wanted:
            print(name.replace('_', ' '), flush=True)
            session()
