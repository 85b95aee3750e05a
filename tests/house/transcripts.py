"""The manual's transcripts are correct: every `$ proskill …` in a console block prints the text below it.

A line `…` stands for any lines, `…` within a line for any text. Commands run at the root of the tree.
usage: transcripts.py PROGRAM
"""

import difflib
import re
import shlex
import subprocess
import sys

from house import ROOT, files, finish, read

PROGRAM = sys.argv[1]
BLOCK = re.compile(r"^```console\n(.*?)^```", re.M | re.S)


def commands(page):
    """Each command of a page with the lines that it should print."""
    for block in BLOCK.findall(read(page)):
        for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, *expected = part.rstrip("\n").split("\n")
            yield command, expected


def pattern(expected):
    lines = [r"(?:.*\n)*?" if line.strip() == "…"
             else r".*".join(re.escape(piece) for piece in line.rstrip().split("…")) + r"[ ]*\n"
             for line in expected]
    return re.compile("".join(lines))


def run(command):
    words = shlex.split(command)
    done = subprocess.run([PROGRAM, *words[1:]], cwd=ROOT, capture_output=True, text=True, timeout=120)
    return (done.stdout + done.stderr).strip("\n") + "\n"


complaints, ran = [], 0
for page in files(".md"):
    for command, expected in commands(page):
        if not command.startswith("proskill ") or re.search(r"[|>]", command):
            complaints.append(f"{page}: $ {command}: a transcript is of one proskill command")
            continue
        ran += 1
        printed = run(command)
        if not pattern(expected or [""]).fullmatch(printed):
            complaints.append(f"{page}: $ {command}: prints something else")
            complaints += difflib.unified_diff(expected, printed.splitlines(), "the page", "the program",
                                               lineterm="")
finish(complaints, f"{ran} transcripts")
