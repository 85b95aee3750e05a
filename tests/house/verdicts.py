"""Every example has the verdicts recorded in tests/house/verdicts/.

usage: verdicts.py PROGRAM [--write]      --write: record the current ones
"""

import difflib
import json
import re
import subprocess
import sys

from house import ROOT, files, finish, read

PROGRAM = sys.argv[1]
WRITE = "--write" in sys.argv
WRITTEN = "tests/house/verdicts"


def roots():
    """The examples that no other example includes, or that have recorded verdicts of their own."""
    examples = [name for name in files(".proskill") if name.startswith("examples/")]
    models = [name for name in files(".fcr") if name.startswith("examples/")]
    included = {name.rsplit("/", 1)[0] + "/" + path for name in examples
                for path in re.findall(r'^\(include "([^"]+)"\)', read(name), re.M)}
    return [name for name in examples if name not in included or page(name).exists()] + models


def page(example):
    return ROOT / example.replace("examples", WRITTEN, 1).replace(".proskill", ".txt").replace(".fcr", ".txt")


def verdicts(example):
    """A line for each property, or what went wrong."""
    done = subprocess.run([PROGRAM, "verify", "--format", "json", example],
                          cwd=ROOT, capture_output=True, text=True, timeout=120)
    if done.returncode not in (0, 1, 3):
        return [f"exit code {done.returncode}", *done.stderr.splitlines()]
    return [f"{row['name']} {row['verdict']}" for row in json.loads(done.stdout)["properties"]]


complaints = []
for example in roots():
    found = verdicts(example)
    if WRITE:
        page(example).parent.mkdir(parents=True, exist_ok=True)
        page(example).write_text("\n".join(found) + "\n", encoding="utf-8")
    written = page(example).read_text(encoding="utf-8").splitlines() if page(example).exists() else []
    complaints += difflib.unified_diff(written, found, f"{example} as written down",
                                       f"{example} now", lineterm="")
finish(complaints, f"{len(roots())} examples")
