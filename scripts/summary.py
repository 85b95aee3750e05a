"""Ends `./dev test`: what took how long, what failed before the tests, what succeeded only at its second try, and what was
skipped and why.

usage: ctest … --output-junit FOLDER/tested-NAME.xml | summary.py FOLDER [--not-tried WHAT REASON]… [--failed WHAT OUTPUT]…

Passes on what ctest prints; its closing lines come last, after the lists. With CI=true it fails if a skip is not one
of tests/skips.txt, whose lines are `test | reason | why it cannot be helped`, with `*` for anything in the first two.
A test prints `retried: WHAT: WHY` for each second try. Of a failed phase the last lines of the file OUTPUT are repeated.
FOLDER/phases/begun.txt has lines `SECONDS PHASE`, with the time at which each phase begins; the last one ends now.
"""

import argparse
import fnmatch
import os
import pathlib
import re
import sys
import time
import xml.etree.ElementTree

LISTED = pathlib.Path(__file__).resolve().parents[1] / "tests/skips.txt"
NO_REASON = "it does not say why"
REPEATED = 30  # lines of a failed phase
LONGEST = 5  # tests whose times are reported
CLOSING = re.compile(r"\d+% tests passed|No tests were found")


def skips(file):
    """The skipped tests of one run of ctest, each with its reason."""
    for case in xml.etree.ElementTree.parse(file).iter("testcase"):
        if case.find("skipped") is None:
            continue
        said = re.search(r"^skipped: (.*)$", case.findtext("system-out") or "", re.M)
        yield case.get("name"), said[1] if said else NO_REASON


def retries(file):
    """What succeeded only at its second try, each with the test that says so."""
    for case in xml.etree.ElementTree.parse(file).iter("testcase"):
        for said in re.findall(r"^retried: (.*)$", case.findtext("system-out") or "", re.M):
            yield case.get("name"), said


def times(file):
    """Of each test of one run of ctest."""
    for case in xml.etree.ElementTree.parse(file).iter("testcase"):
        yield float(case.get("time", 0)), case.get("name")


def durations(begun, since):
    """The phases, each with its seconds. The last one began `since` seconds ago."""
    rows = [line.split(maxsplit=1) for line in begun.read_text(encoding="utf-8").splitlines()] if begun.exists() else []
    ends = [int(row[0]) for row in rows[1:]] + [int(rows[-1][0]) + round(since)] if rows else []
    return [(name, end - int(start)) for (start, name), end in zip(rows, ends)]


def allowed(name, reason, listed):
    return reason != NO_REASON and any(fnmatch.fnmatchcase(name, test) and fnmatch.fnmatchcase(reason, why)
                                       for test, why, _ in listed)


def read_list(file):
    rows = (line.strip() for line in file.read_text(encoding="utf-8").splitlines())
    return [tuple(cell.strip() for cell in row.split("|")) for row in rows if row and not row.startswith("#")]


def pass_on(stream):
    """Passes on the output, except ctest's closing lines, which it returns."""
    closing = []
    for line in stream:
        if closing or CLOSING.search(line):
            closing.append(line)
        else:
            print(line, end="", flush=True)
    return closing


def report_failures(failed):
    """Repeats the end of what failed before the tests: its own place is thousands of lines up."""
    for what, output in failed:
        print(f"\nFailed before the tests: {what}")
        lines = pathlib.Path(output).read_text(encoding="utf-8", errors="replace").splitlines()
        print("".join(f"  {line}\n" for line in lines[-REPEATED:]), end="")


def report_times(phases, tests):
    if phases:
        print(f"\nIn {sum(seconds for _, seconds in phases)} s:", ", ".join(f"{name} {seconds} s" for name, seconds in phases))
    if tests:
        print("The tests that took longest:")
    for seconds, name in sorted(tests, reverse=True)[:LONGEST]:
        print(f"  {seconds:4.0f} s  {name}")


def report_retries(found):
    if found:
        print("\nTried twice, because the first try failed:")
    for name, said in found:
        print(f"  {name}\n      {said}")


def report(found):
    print(f"\n{len(found)} of the tests could not be tried here:" if found else "\nno test was skipped")
    for name, reason in found:
        print(f"  {name}\n      {reason}")
    print()


def main():
    options = argparse.ArgumentParser()
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("--not-tried", nargs=2, action="append", default=[])
    options.add_argument("--failed", nargs=2, action="append", default=[])
    options.add_argument("--listed", type=pathlib.Path, default=LISTED)
    chosen = options.parse_args()
    began = time.monotonic()
    closing = pass_on(sys.stdin)
    runs = list(chosen.folder.glob("tested-*.xml"))  # ctest has now written the last of them
    found = sorted({*(skip for file in runs for skip in skips(file)), *map(tuple, chosen.not_tried)})
    report_times(durations(chosen.folder / "phases/begun.txt", time.monotonic() - began),
                 [each for file in runs for each in times(file)])
    report_failures(chosen.failed)
    report_retries(sorted(retry for file in runs for retry in retries(file)))
    report(found)
    unlisted = [name for name, reason in found if not allowed(name, reason, read_list(chosen.listed))]
    fails = unlisted and os.environ.get("CI") == "true"
    if not runs:
        print(f"failed: ctest left no {chosen.folder}/tested-*.xml\n")
    if fails:
        print(f"failed: CI=true, and tests/skips.txt does not allow to skip {', '.join(unlisted)}\n")
    print("".join(closing), end="")
    return 1 if fails or chosen.failed or not runs else 0


if __name__ == "__main__":
    sys.exit(main())
