#!/usr/bin/env python3
"""Checks the timed automata of `proskill emit tchecker` with a reader and an exploration of their own (zones.py).

    automata.py [--each N] PROGRAM PRINT_MODELS

TChecker itself is not run here; crosscheck.py does so where it is installed. On random models and on members of bench/families.py, the
reachable labels must be the verdicts of `proskill verify`, and the reachable locations as many as its discrete states.
"""
import argparse
import pathlib
import sys
import tempfile

import tchecker
import zones
from crosscheck import MODELS, disagreements, families, models_of, report
from verdicts import Ours, Refused

KINDS = ["plain", "data", "observer", "untimed-data"]
MOST_SUCCESSORS = 6000
MOST_LOCATIONS = 4000


class Totals:
    models = compared = locations = verdicts = found = counted = 0


def compare(program, model, where):
    ours = Ours(program, model, where)
    Totals.models += 1
    try:
        automaton = tchecker.emitted(ours)
        answers = ours.found()
    except Refused:
        return
    few = len(automaton.locations) < MOST_LOCATIONS
    reached = zones.Explorer(automaton).reached(MOST_SUCCESSORS) if few else None
    if reached is None:
        return
    seen = {label for name in reached for label in automaton.locations[name].get("labels", "").split(",")}
    found = {question: label in seen for label, question in automaton.labels.items()}
    Totals.compared += 1
    Totals.verdicts += len(set(answers) & set(found))
    Totals.found += sum(found.values())
    yield from disagreements(answers, found, True, "the automaton")
    states = sum(not name.startswith("sink_") for name in reached)
    Totals.locations += states
    mine = ours.markings()
    if mine is not None:
        Totals.counted += 1
        if mine != states:
            yield f"discrete states: ours {mine}, the automaton {states}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--each", type=int, default=20)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("print_models", type=pathlib.Path)
    arguments = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        where = pathlib.Path(name)
        models = [model for kind in KINDS for model in models_of(kind, arguments.print_models.resolve(), where, arguments.each)]
        for model in [*models, *families(where), *MODELS.glob("*.fcr")]:
            problems = list(compare(arguments.program.resolve(), model, where))
            report(model, problems)
            failed += bool(problems)
    print(f"{Totals.compared} of {Totals.models} models: {Totals.locations} locations reached, {Totals.counted} times counted; "
          f"{Totals.verdicts} verdicts, {Totals.found} of them found")
    if Totals.compared < Totals.models / 2 or Totals.counted < Totals.models / 3:
        print("too few models were compared")
        failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
