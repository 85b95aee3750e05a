"""Measures live verification: numbers of the examples are changed, and the time from the edit to the verdicts on the changed program is
taken. No version is verified twice. The baseline is `proskill verify` of the example, from start to end. Usage: live.py PROSKILL [--edits N]"""

import argparse
import os
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'tests' / 'lsp' / 'sessions'))
from client import Client, Text  # noqa: E402

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / 'examples'
PROGRAMS = ['drone/drone', 'gripper/gripper', 'gripper/mission', 'lift/building', 'lift/timed']  # each text is of one program


def verdicts(client):
    """The verdicts on the current text, and when they came; none if it has errors."""
    note, when = client.timed_note('proskill/verdicts', lambda params: params['state'] == 'errors' or
                                   params['state'] == 'done' and not params['stale'])
    return (None if note['state'] == 'errors' else note['counts']), when


def numbers(text):
    """Where intervals and ranges have numbers: other numbers, such as those of commands, may mean nothing to a verifier."""
    code = re.sub(r';[^\n]*', lambda it: ' ' * len(it[0]), text)
    return [found.span(1) for found in re.finditer(r'(?:\[|,|:min |:max |:init )(\d+)(?=[],) \n])', code)]


def measure(command, path, edits, random):
    with tempfile.TemporaryDirectory() as cache:
        client = Client([*command, 'lsp'], env={**os.environ, 'XDG_CACHE_HOME': cache})
        client.initialize(initializationOptions={'trusted': True})
        text = Text(path.as_uri(), path.read_text())
        client.open(text.uri, text.text)
        verdicts(client)
        times, inconclusive = [], 0
        for change in range(1, edits + 1):
            begin, end = random.choice(numbers(text.text))
            old = text.text[begin:end]
            new = str(int(old) + change)
            text.edit(client, begin, end, new)
            sent = time.perf_counter()
            counts, when = verdicts(client)
            if counts:
                times.append(when - sent)
                inconclusive += counts['inconclusive']
            text.edit(client, begin, begin + len(new), old)
            verdicts(client)
        client.end()
    return sorted(times), inconclusive


def alone(program, path):
    times = []
    for _ in range(5):
        begin = time.perf_counter()
        subprocess.run([program, 'verify', path], stdout=subprocess.DEVNULL)
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('proskill')
    parser.add_argument('--edits', type=int, default=30)
    arguments = parser.parse_args()
    print(f'{"program":20} {"p50 ms":>8} {"p95 ms":>8} {"most":>8} {"edits":>6} {"inconclusive":>13} {"p50 / verify":>13}   goal of p50: 200')
    for name in PROGRAMS:
        path = EXAMPLES / f'{name}.proskill'
        times, inconclusive = measure([arguments.proskill], path, arguments.edits, random.Random(1))
        if not times:
            print(f'{name:20} no edit without errors')
            continue
        at = lambda part: times[min(len(times) - 1, int(part * len(times)))] * 1000
        middle = statistics.median(times)
        print(f'{name:20} {middle * 1000:8.0f} {at(0.95):8.0f} {times[-1] * 1000:8.0f} {len(times):6} {inconclusive:13} '
              f'{middle / alone(arguments.proskill, path):13.1f}', flush=True)


main()
