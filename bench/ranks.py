#!/usr/bin/env python3
"""What a search by several ranks costs, and what it would on more machines than one has.

usage: ranks.py measure PROSKILL            bytes and messages of 1, 2 and 4 ranks under mpirun
       ranks.py model                       seconds by the formula of docs/scale.md, and by a simulation

The simulation has a clock for each rank. It sends each message by itself, which arrives after the injected latency, and has
each rank wait for all that is sent to it and for the barrier. The formula knows averages only.
"""

import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MODELS = [("philosophers", 11), ("fischer", 9), ("csma", 8)]
SAME_GRAPH = "dead-variables,live-variables,free-inputs,private-moves,stubborn-sets,extrapolation"

# Of a network with switches: seconds, bytes a second, seconds of a processor for a message.
LATENCY, BANDWIDTH, OVERHEAD = 20e-6, 1.25e9, 2e-6
BATCH = 16 << 10

# A search whose levels first grow and then shrink.
CLASSES, LEVELS = 100_000_000, 60
PER_CLASS, RECORD = 6, 12  # successors of a class, and bytes of one that is sent
SECONDS = 8e-6  # to expand a class, with all its successors


def measure(program):
    print("| model | ranks | classes | transitions | messages | bytes a transition | processor seconds |\n| --- |" + " --: |" * 6)
    with tempfile.TemporaryDirectory() as directory:
        for family, size in MODELS:
            file = os.path.join(directory, "model.fcr")
            with open(file, "w", encoding="utf-8") as out:
                subprocess.run([sys.executable, os.path.join(ROOT, "bench/families.py"), family, str(size)], stdout=out, check=True)
            for ranks in 0, 1, 2, 4:
                print(row(f"{family} {size}", ranks, *exploration(program, file, ranks)), flush=True)


def exploration(program, file, ranks):
    """The counts of a run, and what it took of all processors. Without ranks: of a process without `--mpi`."""
    as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    prefix = ["mpirun", "--oversubscribe", *as_root, "-n", str(ranks)] if ranks else []
    command = [*prefix, program, "verify", *(["--mpi"] if ranks else ["--jobs", "1"]), "--format", "json", "--traces", "none",
               "--reduce", SAME_GRAPH, file]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    report = json.loads(subprocess.run(command, capture_output=True, text=True, check=False).stdout)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return report["exploration"], after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def row(name, ranks, size, seconds):
    sent = size.get("ranks", {"messages": 0, "bytes": 0})
    return (f"| {name} | {ranks or 'no `--mpi`'} | {size['classes']:,} | {size['transitions']:,} | {sent['messages']:,} | "
            f"{sent['bytes'] / size['transitions']:.1f} | {seconds:.2f} |")


def levels():
    """The classes of each level: a bell, as breadth-first searches mostly have it."""
    weights = [math.exp(-((i - LEVELS / 2) / (LEVELS / 6)) ** 2 / 2) for i in range(LEVELS)]
    return [round(CLASSES * weight / sum(weights)) for weight in weights]


def rounds(ranks):
    """Of messages that follow each other in a barrier and a sum."""
    return 3 * math.ceil(math.log2(ranks)) if ranks > 1 else 0


def by_formula(ranks, latency):
    total = 0
    for classes in levels():
        own = classes / ranks
        data = own * PER_CLASS * RECORD * (ranks - 1) / ranks  # bytes that a rank sends in the level
        messages = max(data / BATCH, min(ranks - 1, own * PER_CLASS))
        # the rank with the most classes of the level is some deviations above the average
        most = own + math.sqrt(2 * own * math.log(ranks)) if ranks > 1 else own
        total += most * SECONDS + 2 * messages * OVERHEAD + data / BANDWIDTH
        total += (rounds(ranks) + (2 if ranks > 1 else 0)) * latency
    return total


def by_simulation(ranks, latency):
    generator = random.Random(ranks)
    clocks = [0.0] * ranks
    for classes in levels():
        clocks = level(clocks, classes / ranks, latency, generator)
    return max(clocks)


def level(clocks, average, latency, generator):
    """The clocks of the ranks after a level, from those before."""
    ranks = len(clocks)
    arrivals = [0.0] * ranks  # of the last message to each rank
    received = [0] * ranks
    ends = []
    for rank, clock in enumerate(clocks):
        own = max(0.0, generator.gauss(average, math.sqrt(average)))
        work = own * SECONDS
        data = own * PER_CLASS * RECORD / ranks  # bytes for each other rank
        each = max(1, math.ceil(data / BATCH)) if own * PER_CLASS >= ranks else 0
        some = own * PER_CLASS / ranks  # the chance of a message where not every rank gets one
        for step in range(1, ranks):
            clock += work / (ranks - 1)
            count = each or int(generator.random() < some)
            if count == 0:
                continue
            to = (rank + step) % ranks
            clock += count * OVERHEAD + data / BANDWIDTH
            arrivals[to] = max(arrivals[to], clock + latency)
            received[to] += count
        ends.append(clock if ranks > 1 else clock + work)
    ends = [max(end, arrival) + count * OVERHEAD for end, arrival, count in zip(ends, arrivals, received)]
    # the senders hear that their messages have been received; then nobody passes the barrier before the last
    over = max(ends) + latency + rounds(ranks) * latency if ranks > 1 else ends[0]
    return [over] * ranks


def model():
    print("| ranks | latency | formula, s | simulation, s | of linear |\n| --: | --: | --: | --: | --: |")
    alone = by_formula(1, 0)
    for latency in LATENCY, 50 * LATENCY:
        for ranks in 1, 10, 100, 1000:
            seconds = by_simulation(ranks, latency)
            print(f"| {ranks:,} | {latency * 1e6:.0f} µs | {by_formula(ranks, latency):.2f} | {seconds:.2f} | "
                  f"{100 * alone / ranks / seconds:.0f} % |", flush=True)


if sys.argv[1:2] == ["measure"]:
    measure(sys.argv[2])
elif sys.argv[1:] == ["model"]:
    model()
else:
    sys.exit(__doc__)
