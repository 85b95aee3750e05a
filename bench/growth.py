"""Measures how the cost of verification grows with a program: `python3 bench/growth.py build/bin/proskill [OTHER…]`.

Each family is one program at several sizes. Printed are classes, user seconds and memory of one process that
answers all default properties; a run is ended after a minute."""

import os
import re
import subprocess
import sys
import tempfile

SECONDS = 60

SENSOR = """(defsv sensor_{i} :states (Good Fair Bad) :init Good :transitions :all)
(defevent good_{i} :effects (sensor_{i} Good))
(defevent fair_{i} :effects (sensor_{i} Fair))
(defevent bad_{i} :effects (sensor_{i} Bad))
"""

STEP = """(defsv {d} :states (Off Ready Busy) :init Ready)
(defskill {s} :precondition (p ({d} Ready){more}) :start ({d} Busy) :time_interval [1,{last}] :action (a)
  :interrupt (:effects ({d} Ready)) :success done (:effects ({d} Ready)) :failure lost (:effects ({d} Ready)))
"""


def skill(name, i, more=""):
    return STEP.format(d=f"dev_{name}", s=f"step_{name}", more=more, last=3 + i % 4)


def calls(names):
    return "".join(f"(step_{n}) (if (/= step_{n}.status success) (failure f))\n" for n in names)


def mission(names, name="mission"):
    return f"(defskill {name} :success ok :failure f :body (\n{calls(names)}(success ok)))\n"


def row(n):
    return "".join(skill(str(i), i) for i in range(n)) + mission([str(i) for i in range(n)])


def sensors(n):
    text = "".join(SENSOR.format(i=i) for i in range(n))
    text += "".join(skill(str(i), i, f" q (not (sensor_{i % n} Bad)) r (not (sensor_{(i + 1) % n} Bad))")
                    for i in range(10))
    return text + mission([str(i) for i in range(10)])


def monitors(n):
    text = "".join(skill(str(i), i) for i in range(2)) + mission(["0", "1"])
    for i in range(n):
        text += (f"(defsv alarm_{i} :states (Quiet Loud) :init Quiet)\n"
                 f"(defevent on_{i} :effects (alarm_{i} Loud))\n(defevent off_{i} :effects (alarm_{i} Quiet))\n"
                 f"(defskill mon_{i} :monitor t :body ((while true (^ (alarm_{i} Loud)) (step_{i % 2}.interrupt) "
                 f"(^ (alarm_{i} Quiet)))))\n")
    return text


def robots(n):
    text, parts = "", []
    for r in range(n):
        names = [f"{r}_{i}" for i in range(3)]
        text += "".join(skill(name, i) for i, name in enumerate(names))
        text += mission(names, f"robot_{r}")
        parts.append(f"((robot_{r}))")
    body = f"(// {' '.join(parts)})" if n > 1 else parts[0][1:-1]
    return text + f"(defskill mission :success ok :body ({body} (success ok)))\n"


def day(seconds):
    return ("(defsv go :states (Yes No) :init Yes)\n(defevent stop :effects (go No))\n"
            "(defskill look :time_interval [1,2] :action (l) :success d)\n"
            f"(defskill mission :time_interval [{seconds // 2},{seconds}] :success done :body (\n"
            "(while (go Yes) (look) (^ 1)) (success done)))\n")


FAMILIES = [("skills in a row", row, (64, 128, 256, 512)), ("sensors", sensors, (2, 4, 8, 16)),
            ("monitors", monitors, (2, 4, 6, 8)), ("robots that share nothing", robots, (1, 2, 3)),
            ("seconds of a patrol", day, (5400, 21600, 86400))]


def measure(program, file):
    """Classes, user seconds and MiB; None if it fails."""
    with tempfile.TemporaryFile("w+") as out:
        process = subprocess.Popen([program, "verify", "--traces", "none", "--time-limit", str(SECONDS), file],
                                   stdout=out, stderr=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        out.seek(0)
        found = re.search(r"^(\d+) class", out.read(), re.M)
    if os.waitstatus_to_exitcode(status) not in (0, 1) or not found:
        return None
    return found.group(1), used.ru_utime, used.ru_maxrss / 1024


def main():
    for title, make, sizes in FAMILIES:
        for size in sizes:
            with tempfile.NamedTemporaryFile("w", suffix=".proskill") as file:
                file.write(make(size))
                file.flush()
                figures = [measure(program, file.name) for program in sys.argv[1:]]
            told = ["not done" if not f else f"{f[0]} classes, {f[1]:.2f} s, {f[2]:.0f} MiB" for f in figures]
            print(f"| {title} | {size} | {' | '.join(told)} |", flush=True)


main()
