#!/usr/bin/env python3
"""Compares the verifier with Spin, and with TChecker where it is installed.

    crosscheck.py [--short] [--each N] PROGRAM PRINT_MODELS

Models: the examples, members of bench/families.py, those in models/, and random models. Without time: the numbers of states and of transitions, and all
verdicts that Spin can give. With time: the verdicts in discrete time, and by TChecker. Prints a table. Fails on a disagreement, with the
model.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

import tchecker
from spin import Spin
from verdicts import Ours, Refused

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS = pathlib.Path(__file__).resolve().parent / "models"
KINDS = ["untimed", "untimed-data", "untimed-observer", "plain", "data", "observer"]
FAMILIES = [("philosophers", 3), ("philosophers", 8), ("fischer", 3), ("csma", 3)]
EXAMPLES = ["docs/tour/dock.proskill", "docs/tour/watched.proskill", "examples/gripper/gripper.proskill", "examples/rover/world.proskill",
            "examples/ros1/patrol.proskill", "examples/gripper/mission.proskill"]


class Row:
    """Totals of a line of the table."""

    def __init__(self, name):
        self.name = name
        self.models = self.counted = self.states = self.verdicts = self.found = self.unfinished = self.by_tchecker = 0
        self.refused = {}

    def show(self):
        note = "; ".join(f"{count} refused: {why}" for why, count in sorted(self.refused.items()))
        note += f"{'; ' if note and self.unfinished else ''}{f'{self.unfinished} not finished: compared as far as Spin came' if self.unfinished else ''}"
        print(f"{self.name:34} {self.models:6} {self.counted:8} {self.states:9} {self.verdicts:9} {self.found:8} {self.by_tchecker:9}  {note}",
              flush=True)


def disagreements(ours, theirs, exact, who):
    """One line for each property about which they disagree. Inexact: they may find less."""
    for name in sorted(set(ours) & set(theirs)):
        if ours[name] != theirs[name] and (exact or theirs[name]):
            yield f"`{name}`: ours {'found' if ours[name] else 'not found'}, {who} {'found' if theirs[name] else 'not found'}"


def compare(program, model, where, row, with_spin):
    """The disagreements about a model."""
    ours = Ours(program, model, where)
    problems = []
    row.models += 1
    try:
        answers = ours.found()
        if with_spin:
            problems += list(by_spin(ours, answers, row))
        if tchecker.installed():
            problems += list(by_tchecker(ours, answers, row))
    except Refused as refused:
        why = str(refused).rsplit("error: ", 1)[-1].splitlines()[0]
        row.refused[why] = row.refused.get(why, 0) + 1
    return problems


def by_spin(ours, answers, row):
    spin = Spin(ours.program, ours.model, ours.where)
    fails = answers.get("no_runtime_error", False)
    if not spin.is_timed and not fails:
        mine, theirs = ours.counts(), spin.counts()
        if mine and theirs:
            row.counted += 1
            row.states += theirs[0]
            if mine != theirs:
                yield f"states and transitions: ours {mine}, Spin {theirs}"
    found = spin.found()
    row.unfinished += not spin.is_finished
    row.verdicts += len(set(answers) & set(found))
    row.found += sum(found.values())
    yield from disagreements(answers, found, spin.is_exact and spin.is_finished, "Spin")


def notices_difference(program, where):
    """Whether a comparison fails if a step of the model is not what it should be: a philosopher keeps a fork."""
    model = next(families(where))
    spin = Spin(program, model, where)
    wrong = spin.text.replace("       v_f1 = 0;", "       skip;", 1)
    assert wrong != spin.text
    (where / "model.pml").write_text(wrong, encoding="utf-8")
    return spin.counts() != Ours(program, model, where).counts()


def by_tchecker(ours, answers, row):
    automaton = tchecker.emitted(ours)
    found = {name: tchecker.reaches(automaton, label, ours.where) for label, name in automaton.labels.items()}
    row.by_tchecker += len(set(answers) & set(found))
    yield from disagreements(answers, found, True, "TChecker")


def models_of(kind, print_models, where, count):
    subprocess.run([print_models, kind, "0", str(count), where], check=True)
    return [where / f"{kind}-{seed}.fcr" for seed in range(count)]


def families(where):
    for name, size in FAMILIES:
        model = where / f"{name}-{size}.fcr"
        made = subprocess.run([sys.executable, "-B", ROOT / "bench/families.py", name, str(size)], capture_output=True, text=True, check=True)
        model.write_text(made.stdout, encoding="utf-8")
        yield model


def report(model, problems):
    for problem in problems:
        print(f"DISAGREEMENT on {model}: {problem}")
    if problems and model.suffix == ".fcr":
        print(model.read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--short", action="store_true", help="some dozens of models")
    parser.add_argument("--each", type=int, help="random models of each kind")
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("print_models", type=pathlib.Path)
    arguments = parser.parse_args()
    missing = [tool for tool in ("spin", "cc") if not shutil.which(tool)]
    if missing and (arguments.short or not tchecker.installed()):
        print(f"skipped: {missing[0]} is not installed (Debian: {'spin' if missing[0] == 'spin' else 'gcc'})")
        return 77
    print(f"{'':34} models  counted    states  verdicts    found  TChecker")
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        where = pathlib.Path(name)
        if not missing and not notices_difference(arguments.program.resolve(), where):
            print("a wrong model is not noticed")
            failed += 1
        rows = [(kind, models_of(kind, arguments.print_models.resolve(), where, arguments.each or (6 if arguments.short else 60)))
                for kind in KINDS]
        rows += [(model.stem, [model]) for model in [*families(where), *sorted(MODELS.glob("*.fcr"))]]
        if not arguments.short:
            rows += [(example, [ROOT / example]) for example in EXAMPLES]
        for title, models in rows:
            row = Row(title)
            for model in models:
                problems = compare(arguments.program.resolve(), model, where, row, not missing)
                report(model, problems)
                failed += bool(problems)
            row.show()
    print(f"{failed} model(s) with a disagreement" if failed else "all agree")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
