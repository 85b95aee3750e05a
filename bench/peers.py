#!/usr/bin/env python3
"""Compares the verifier with one and with several threads, and with Spin if it is installed.

    bench/peers.py [--short] [PROGRAM]     # PROGRAM: default build/bin/proskill

For each model: states and transitions, time of a wall clock, processor time, resident bytes a state. Models without time are explored by
Spin, too, without partial order reduction: once written by hand, with a process for each philosopher, and once as `proskill emit promela` writes
it. Its counts must be the same. The ratio of two threads to one is of the wall clock, those to Spin are of processor time, both in this run.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
MODELS = [("philosophers", 14), ("fischer", 12), ("csma", 10)]
SHORT = [("philosophers", 12), ("fischer", 10), ("csma", 9)]


def measure(command, where):
    """The output of a command, its wall and processor time in seconds, and its resident memory in bytes."""
    with tempfile.TemporaryFile("w+") as output:
        begun = time.monotonic()
        child = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, cwd=where)
        _, _, usage = os.wait4(child.pid, 0)
        wall = time.monotonic() - begun
        output.seek(0)
        return output.read(), wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def text_of(*family):
    return subprocess.run([HERE / "families.py", *map(str, family)], capture_output=True, text=True, check=True).stdout


def show(name, states, transitions, wall, processor, resident):
    print(f"  {name:12} {states:>10} states {transitions:>10} transitions  {wall:7.2f} s  {processor:7.2f} s of processors"
          f"  {resident / states:7.1f} B a state")


def ours(program, model, jobs, where):
    (where / "model.fcr").write_text(model, encoding="utf-8")
    # one exploration of the whole, with the steps that the model has
    command = [program, "verify", "model.fcr", "--traces", "none", "--jobs", str(jobs), "--reduce", "inclusion,extrapolation"]
    output, wall, processor, resident = measure(command, where)
    sizes = re.search(r"^(\d+) classes, \d+ markings, (\d+) transitions", output, re.M)
    show(f"{jobs} thread(s)", int(sizes[1]), int(sizes[2]), wall, processor, resident)
    return (int(sizes[1]), int(sizes[2])), processor, wall


def spin(name, model, where):
    (where / "model.pml").write_text(model, encoding="utf-8")
    subprocess.run(["spin", "-a", "-o1", "-o2", "-DCOUNTS", "model.pml"], cwd=where, check=True, capture_output=True)
    subprocess.run(["cc", "-O2", "-DSAFETY", "-DNOREDUCE", "-DMEMLIM=16000", "-o", "pan", "pan.c"], cwd=where, check=True)
    output, wall, processor, resident = measure(["./pan", "-E", "-m20000000", "-w24"], where)
    # Spin counts the initial state as a transition, too.
    counts = int(re.search(r"(\d+) states, stored", output)[1]), int(re.search(r"(\d+) transitions", output)[1]) - 1
    show(name, *counts, wall, processor, resident)
    return counts, processor


def compare_with_spin(program, family, mine, processor, where):
    """Prints ratios. \return whether the counts are the same"""
    emitted = subprocess.run([program, "emit", "promela", "model.fcr"], cwd=where, capture_output=True, text=True, check=True).stdout
    same = True
    for name, model in (("Spin", text_of(*family, "promela")), ("Spin, emitted", emitted)):
        counts, its = spin(name, model, where)
        print(f"  {name} takes {its / processor:.1f} times as long as one thread")
        if counts != mine:
            print(f"  {name} counts other states or transitions")
            same = False
    return same


def main():
    words = [word for word in sys.argv[1:] if word != "--short"]
    program = pathlib.Path(words[0] if words else HERE.parent / "build/bin/proskill").resolve()
    same = True
    for family, size in SHORT if "--short" in sys.argv else MODELS:
        print(family, size)
        with tempfile.TemporaryDirectory() as name:
            where = pathlib.Path(name)
            (counts, processor, alone), (others, _, together) = [ours(program, text_of(family, size), jobs, where) for jobs in (1, 2)]
            print(f"  two threads are {alone / together:.2f} times as fast as one")
            if counts != others:
                print("  two threads count other states or transitions")
                same = False
            if family == "philosophers" and shutil.which("spin"):
                same = compare_with_spin(program, (family, size), counts, processor, where) and same
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
