#!/usr/bin/env python3
"""Counts a graph of state classes of the size that the paper reports: the drone of examples/drone beside a sun and a second drone.

    bench/paper_size.py [--sectors N] [--jobs N] [PROGRAM]     # sectors: default 19; jobs: all processors; PROGRAM: build/bin/proskill

The second drone circles over N sectors, while the light of the day changes through six phases. Both are independent of the mission, so the graph
has 6 N times the classes of the drone. Prints both graphs' counts, times, and resident bytes a class. The default takes 7 GB and 24 min.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
DRONE = HERE.parent / "examples/drone/drone.proskill"
PHASES = ["Dawn", "Morning", "Noon", "Afternoon", "Dusk", "Night"]
PAPER = "paper: 1545614784 classes, 372325248 markings, 12761 domains, 23154942608 transitions in 112 h 17 min"


def cycle(name, states):
    """A state variable that events lead through its states, again and again."""
    yield f"(defsv {name}\n  :states ({' '.join(states)})\n  :init {states[0]}\n  :transitions :all)"
    for before, after in zip(states, states[1:] + states[:1]):
        yield f"(defevent {name}_{after.lower()}\n  :guard ({name} {before})\n  :effects ({name} {after}))"


def program_with(sectors):
    others = [*cycle("daylight", PHASES), *cycle("sector", [f"S{i}" for i in range(1, sectors + 1)])]
    return DRONE.read_text(encoding="utf-8") + "\n" + "\n\n".join(others) + "\n"


def counts_of(proskill, jobs, text):
    """Counts the classes of a program, and prints what that took. \\return classes, markings, domains, transitions"""
    with tempfile.NamedTemporaryFile("w+", suffix=".proskill", encoding="utf-8") as file, tempfile.TemporaryFile("w+") as output:
        file.write(text)
        file.flush()
        begun = time.monotonic()
        command = [proskill, "verify", "--graph", "counts", "--jobs", str(jobs), file.name]
        child = subprocess.Popen(command, stdout=output)
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.monotonic() - begun
        output.seek(0)
        numbers = [int(number) for number in re.findall(r"(\d+) [a-z]+\(s\)", output.read())]
    if os.waitstatus_to_exitcode(status) != 0 or len(numbers) != 4:
        sys.exit("the graph was not counted")
    classes, markings, domains, transitions = numbers
    processor = usage.ru_utime + usage.ru_stime
    print(f"{classes} classes, {markings} markings, {domains} domains, {transitions} transitions in {wall:.1f} s, {processor:.1f} s of the processor, "
          f"{classes / wall / 1e6:.2f} million classes/s, {usage.ru_maxrss * 1024 / classes:.1f} B a class", flush=True)
    return numbers


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sectors", type=int, default=19)
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("program", nargs="?", default=HERE.parent / "build/bin/proskill")
    wanted = parser.parse_args()
    alone = counts_of(wanted.program, wanted.jobs, DRONE.read_text(encoding="utf-8"))
    print(PAPER)
    both = counts_of(wanted.program, wanted.jobs, program_with(wanted.sectors))
    factor = len(PHASES) * wanted.sectors
    if both[0] != factor * alone[0] or both[1] != factor * alone[1]:
        sys.exit(f"the graph does not have {factor} times the classes and markings of the drone")


if __name__ == "__main__":
    main()
