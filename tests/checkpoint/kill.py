#!/usr/bin/env python3
"""Kills a verification at random moments, runs the same command again until it ends, and compares
its report with that of a run that nobody disturbed.

    tests/checkpoint/kill.py PROSKILL KILLS [SEED]

KILLS is the least number of kills of each of the programs and models together.
"""
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EVERY = "0.03"  # seconds: some kills meet a write
INCONCLUSIVE = 3  # the exit code
MOST_KILLS = 30  # of one run; on a busy machine it may not get far between two of them

# what is verified, with the arguments: with time and without, with reductions and without, with
# several threads, with many goals, with searches of whole runs, and counts of state classes
RUNS = [
    ("csma 7", ["--reduce", "extrapolation"]),
    ("csma 8", []),
    ("fischer 8", ["--jobs", "2"]),
    ("philosophers 10", []),
    ("examples/lift/timed.proskill", ["--traces", "all"]),
    ("examples/rover/skills.proskill", ["--traces", "all", "--jobs", "2"]),
    ("bench/missions/hospital_carts.proskill", ["--traces", "all"]),
    ("csma 7", ["--graph", "counts"]),
    ("examples/lift/timed.proskill", ["--graph", "counts"]),
]


def model_of(name, directory):
    """The file of a program, or of a member of a family of models."""
    if "/" in name:
        return os.path.join(ROOT, name)
    family, size = name.split()
    path = os.path.join(directory, family + size + ".fcr")
    if not os.path.exists(path):
        text = subprocess.run([sys.executable, os.path.join(ROOT, "bench/families.py"), family, size],
                              check=True, capture_output=True, text=True).stdout
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    return path


def without_costs(text):
    """A report without what may differ from one run to another: its seconds and bytes."""
    if not text.startswith("{"):
        return text.split("\n")[0]
    report = json.loads(text)
    for cost in "seconds", "bytes":
        report["exploration"].pop(cost)
    return report


def undisturbed(command):
    begun = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    return without_costs(done.stdout), done.returncode, time.monotonic() - begun


def killed(command, seconds, how):
    """Runs a command for some time at most. Returns what it printed and its exit code, or nothing
    if it was ended before."""
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        out, problems = child.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        child.send_signal(how)
        _, problems = child.communicate()
        # Asked to end, it reports what it has decided by then; it may also have come to its end.
        assert child.returncode in (-how, 0, 1, INCONCLUSIVE), problems
        return None, None, problems
    return out, child.returncode, problems


def disturb(name, arguments, directory, generator):
    """Kills a run again and again until it ends. Returns how often, and how often it went on."""
    command = [sys.argv[1], "verify", "--format", "json", *arguments, model_of(name, directory)]
    expected, code, took = undisturbed(command)
    state = os.path.join(directory, "state")
    command[2:2] = ["--checkpoint", state, "--every", EVERY]
    kills = resumed = 0
    while True:
        how = generator.choice([signal.SIGKILL] * 4 + [signal.SIGTERM])
        seconds = generator.uniform(0.02, 0.05 + 0.6 * took) if kills < MOST_KILLS else None
        out, found, problems = killed(command, seconds, how)
        resumed += "goes on from" in problems
        if out is not None:
            break
        kills += 1
    assert found == code, f"{name}: exit code {found} instead of {code}\n{problems}"
    seen = without_costs(out)
    if seen != expected:
        print(json.dumps(expected, indent=1), "\nafter", kills, "kills:\n", json.dumps(seen, indent=1))
        sys.exit(f"{name} {arguments}: the report differs")
    assert not os.path.exists(state), f"{state} is left"
    return kills, resumed


def main():
    least = int(sys.argv[2])
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else random.randrange(1 << 30)
    print("seed", seed)
    generator = random.Random(seed)
    with tempfile.TemporaryDirectory() as directory:
        kills = resumed = runs = 0
        while kills < least or runs < len(RUNS):
            name, arguments = RUNS[runs % len(RUNS)]
            more, again = disturb(name, arguments, directory, generator)
            print(f"{name} {' '.join(arguments)}: killed {more} times, went on {again} times")
            kills, resumed, runs = kills + more, resumed + again, runs + 1
    print(f"{kills} kills, {resumed} of them went on from a checkpoint, {runs} reports are equal")
    assert resumed > 0


main()
