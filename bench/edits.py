"""Measures what an edit costs if verdicts are kept: `python3 bench/edits.py build/bin/proskill [OTHER…]`.

Each program consists of many parts. Printed are the user time and the classes of a process that verifies
it for the first time, again, and after the time of one action has been changed; the last column is edit / first."""

import os
import re
import subprocess
import sys
import tempfile

BASIC = """(defsv dev_{i} :states (Off Ready Busy) :init Ready)
(defevent off_{i} :effects (dev_{i} Off))
(defevent ready_{i} :effects (dev_{i} Ready))
(defskill step_{i} :precondition (p (dev_{i} Ready)) :invariant (on (:guard (/= dev_{i} Off))) :start (dev_{i} Busy)
  :time_interval [1,{last}] :action (a) :interrupt (:effects (dev_{i} Ready)) :success done (:effects (dev_{i} Ready))
  :failure lost (:effects (dev_{i} Ready)))
"""
TWICE = """(defskill twice_{i} {kind} :success ok :failure f :time_interval [0,20] :body ((step_{i})
  (if (/= step_{i}.status success) (failure f)) (^ 2) (step_{i}) (success ok)))
"""


def parts(text, n, edited):
    return "".join(text.format(i=i, last=9 if edited and i == 3 else 3 + i % 4, kind="{kind}") for i in range(n))


def basic(n, edited):
    return parts(BASIC, n, edited)


def monitors(n, edited):
    return parts(BASIC + TWICE, n, edited).replace("{kind}", ":monitor t")


def parallel(n, edited):
    calls = " ".join(f"((twice_{i}))" for i in range(n))
    mission = f"(defskill mission :success ok :body ((// {calls}) (success ok)))\n"
    return parts(BASIC + TWICE, n, edited).replace("{kind}", "") + mission


PROGRAMS = [("20 basic skills", basic, 20), ("20 monitors, a skill each", monitors, 20),
            ("a mission of 20 parallel branches", parallel, 20), ("100 basic skills", basic, 100)]


def verified(program, text, directory):
    """User time in ms, and classes."""
    file = os.path.join(directory, "program.proskill")
    with open(file, "w", encoding="utf-8") as out:
        out.write(text)
    with tempfile.TemporaryFile("w+") as out:
        process = subprocess.Popen([program, "verify", "--traces", "none", "--time-limit", "60", "--cache",
                                    os.path.join(directory, "cache"), file], stdout=out, stderr=out)
        _, _, used = os.wait4(process.pid, 0)
        out.seek(0)
        classes = re.search(r"^(\d+) class", out.read(), re.M)
    if not classes:
        sys.exit("bench: the program cannot be verified")
    return used.ru_utime * 1000, int(classes[1])


def main():
    print("| program | first | again | after an edit | edit / first |\n| --- | --- | --- | --- | --- |")
    for title, make, size in PROGRAMS:
        for program in sys.argv[1:]:
            with tempfile.TemporaryDirectory() as directory:
                first = verified(program, make(size, False), directory)
                again = verified(program, make(size, False), directory)
                edit = verified(program, make(size, True), directory)
            told = " | ".join(f"{cost:,.0f} ms, {classes} classes" for cost, classes in (first, again, edit))
            print(f"| {title} | {told} | {edit[0] / first[0]:.1%} |", flush=True)


main()
