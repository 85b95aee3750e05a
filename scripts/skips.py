"""Lists the skipped tests with their reasons at the end of `./dev test`.

usage: ctest … --output-junit FOLDER/tested-NAME.xml | skips.py FOLDER [--not-tried WHAT REASON]…

Passes on what ctest prints; its closing lines come last, after the list. With CI=true it fails if a skip is not one
of tests/skips.txt, whose lines are `test | reason | why it cannot be helped`, with `*` for anything in the first two.
"""

import argparse
import fnmatch
import os
import pathlib
import re
import sys
import xml.etree.ElementTree

LISTED = pathlib.Path(__file__).resolve().parents[1] / "tests/skips.txt"
NO_REASON = "it does not say why"
CLOSING = re.compile(r"\d+% tests passed|No tests were found")


def skips(file):
    """The skipped tests of one run of ctest, each with its reason."""
    for case in xml.etree.ElementTree.parse(file).iter("testcase"):
        if case.find("skipped") is None:
            continue
        said = re.search(r"^skipped: (.*)$", case.findtext("system-out") or "", re.M)
        yield case.get("name"), said[1] if said else NO_REASON


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


def report(found):
    print(f"\n{len(found)} of the tests could not be tried here:" if found else "\nno test was skipped")
    for name, reason in found:
        print(f"  {name}\n      {reason}")
    print()


def main():
    options = argparse.ArgumentParser()
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("--not-tried", nargs=2, action="append", default=[])
    options.add_argument("--listed", type=pathlib.Path, default=LISTED)
    chosen = options.parse_args()
    closing = pass_on(sys.stdin)
    runs = list(chosen.folder.glob("tested-*.xml"))  # ctest has now written the last of them
    found = sorted({*(skip for file in runs for skip in skips(file)), *map(tuple, chosen.not_tried)})
    report(found)
    unlisted = [name for name, reason in found if not allowed(name, reason, read_list(chosen.listed))]
    fails = unlisted and os.environ.get("CI") == "true"
    if not runs:
        print(f"failed: ctest left no {chosen.folder}/tested-*.xml\n")
    if fails:
        print(f"failed: CI=true, and tests/skips.txt does not allow to skip {', '.join(unlisted)}\n")
    print("".join(closing), end="")
    return 1 if fails or not runs else 0


if __name__ == "__main__":
    sys.exit(main())
