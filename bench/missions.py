#!/usr/bin/env python3
"""Verifies programs of real size: those of bench/missions/, or others.

    bench/missions.py build/bin/proskill                    # classes, time and memory
    bench/missions.py build/bin/proskill limits [FILE…]     # by how much small limits are exceeded
    bench/missions.py build/bin/proskill reductions [FILE…] # each reduction switched off in turn

The programs of bench/missions/ were written after the engine had been tuned."""

import glob
import os
import re
import subprocess
import sys
import tempfile
import time

SECONDS = 10  # limit of a run that is to end
TIMES = (0.1, 0.3, 1)  # small limits, in seconds
SIZES = (16, 24, 64)  # and in MiB
REDUCTIONS = ("dead-variables", "live-variables", "free-inputs", "private-moves", "stubborn-sets", "slices", "refinement",
              "inclusion", "extrapolation")


def verified(program, file, *options):
    """Report, user seconds, wall seconds, and MiB of a process."""
    with tempfile.TemporaryFile("w+") as out:
        start = time.monotonic()
        process = subprocess.Popen([program, "verify", "--traces", "none", *options, file], stdout=out, stderr=out)
        _, status, used = os.wait4(process.pid, 0)
        wall = time.monotonic() - start
        out.seek(0)
        report = out.read()
    if os.waitstatus_to_exitcode(status) not in (0, 1, 3):
        sys.exit(f"bench: {file} cannot be verified:\n{report}")
    return report, used.ru_utime, wall, used.ru_maxrss / 1024


def left_open(report):
    """Number of open properties. Each names the limit because of which it is open."""
    lines = [line for line in report.splitlines() if ": inconclusive" in line]
    for line in lines:
        if "limit was reached" not in line:
            sys.exit(f"bench: open without a limit: {line}")
    return len(lines)


def classes(report):
    found = re.search(r"^(\d+) class", report, re.M)
    return int(found[1]) if found else 0


def name(file):
    return os.path.splitext(os.path.basename(file))[0]


def times(program, files):
    print("| program | lines | properties, open | classes | user time, memory |\n| --- | --- | --- | --- | --- |")
    for file in files:
        report, user, _, size = verified(program, file, "--time-limit", str(SECONDS))
        asked = re.search(r"^(\d+) propert", report, re.M)[1]
        with open(file, encoding="utf-8") as text:
            lines = len(text.readlines())
        print(f"| {name(file)} | {lines} | {asked}, {left_open(report)} | {classes(report):,} "
              f"| {user:.2f} s, {size:.0f} MiB |", flush=True)


def limits(program, files):
    head = [f"{limit} s" for limit in TIMES] + [f"{limit} MiB" for limit in SIZES]
    print(f"| program | {' | '.join(head)} |\n| --- |{' --- |' * len(head)}")
    for file in files:
        row = []
        for limit in TIMES:
            report, _, wall, _ = verified(program, file, "--time-limit", str(limit))
            row.append(f"{wall:.2f} s, {left_open(report)} open")
        for limit in SIZES:
            report, _, _, size = verified(program, file, "--memory-limit", str(limit), "--time-limit", str(SECONDS))
            row.append(f"{size:.1f} MiB, {left_open(report)} open")
        print(f"| {name(file)} | {' | '.join(row)} |", flush=True)


def reductions(program, files):
    print(f"| program | all | {' | '.join('without ' + one for one in REDUCTIONS)} |\n| --- |{' --- |' * 9}")
    for file in files:
        row = []
        for off in ("", *REDUCTIONS):
            chosen = [part for one in REDUCTIONS if one != off for part in ("--reduce", one)]
            report, user, _, _ = verified(program, file, "--time-limit", str(SECONDS), *chosen)
            row.append("not done" if left_open(report) else f"{classes(report):,}, {user:.2f} s")
        print(f"| {name(file)} | {' | '.join(row)} |", flush=True)


MODES = {"times": times, "limits": limits, "reductions": reductions}

if __name__ == "__main__":
    chosen_mode = sys.argv[2] if len(sys.argv) > 2 else "times"
    here = os.path.join(os.path.dirname(os.path.abspath(__file__)), "missions", "*.proskill")
    MODES[chosen_mode](sys.argv[1], sys.argv[3:] or sorted(glob.glob(here)))
