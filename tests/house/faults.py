"""Each row of the manual's table of faults names tests that inject the fault, and they exist.

usage: faults.py
"""

import re

from house import files, finish, read

MANUAL = "docs/runtime.md"
NAMES = {".cpp": r'TEST_CASE\(\s*"((?:[^"\\]|\\.|"\s*")*)"', ".py": r"def (test_\w+)\("}


def tests():
    """The names of all tests; a long one in C++ may be written in several parts."""
    return {re.sub(r'"\s*"', "", name) for suffix, pattern in NAMES.items() for path in files(suffix)
            if path.startswith("tests/") for name in re.findall(pattern, read(path))}


def rows():
    section = read(MANUAL).split("\n## Faults\n")[1].split("\n## ")[0]
    lines = [line for line in section.splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines[2:]]


known = tests()
complaints = []
named = 0
for fault, *rest in rows():
    injecting = re.findall(r'"([^"]+)"|`(test_\w+)`', rest[1]) if len(rest) == 2 else []
    if not injecting:
        complaints.append(f"{MANUAL}: `{fault}` names no test")
    for name in (text or function for text, function in injecting):
        named += 1
        if name not in known:
            complaints.append(f"{MANUAL}: `{fault}` is tested by `{name}`, which does not exist")
finish(complaints, f"{named} tests of {len(rows())} faults")
