"""`--help` can be read, and the manual page and the completions are made from it.

usage: commands.py PROGRAM
"""

import re
import shutil
import subprocess
import sys

from house import ROOT, finish, read

PROGRAM = sys.argv[1]
GROUPS = {"Selection", "Output", "Limits", "Backends", "Advanced"}


def help_of(*command):
    done = subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True, check=True)
    return done.stdout


def subcommands():
    """The names below `Subcommands:`."""
    _, _, below = help_of().partition("Subcommands:\n")
    return re.findall(r"^  (\S+)", below.split("\n\n")[0], re.M)


def complaints(command):
    """Problems for readers of `--help`."""
    text = help_of(command)
    for sign in ("ENUM", "TEXT", "UINT", "FLOAT", "->", "{", "REQUIRED", "Excludes"):
        if sign in text:
            yield f"proskill {command} --help shows `{sign}`"
    for part in ("Examples:\n  proskill " + command, "Exit code:\n  0 "):
        if part not in text:
            yield f"proskill {command} --help has no `{part}`"
    groups = set(re.findall(r"^([A-Z][^:\n]+):$", text, re.M)) - {"Options", "Positionals", "Examples", "Exit code"}
    for group in sorted(groups - GROUPS):
        yield f"proskill {command} --help has a group `{group}`"
    options = text.partition("\nOptions:\n")[2].split("\n\n")[0]
    for line in re.findall(r"^  (--?\S+)", options, re.M):
        if not line.startswith("-h"):
            yield f"proskill {command} --help: `{line}` stands in no group"
    for line in text.split("Examples:")[0].splitlines():
        if len(line) > 100 and "|" not in line:
            yield f"proskill {command} --help has a line of {len(line)} characters: {line}"


def made():
    """Whether the manual page and the completions match the help."""
    done = subprocess.run([sys.executable, "-B", ROOT / "completions/generate.py", PROGRAM, "--check"],
                          capture_output=True, text=True)
    return (done.stdout + done.stderr).splitlines()


def section(title):
    """A section of the manual page, in troff."""
    return read("man/proskill.1").partition(f"\n.SH {title}\n")[2].partition("\n.SH ")[0]


def missing_in_manual():
    """Commands and exit codes of `--help` that the manual page lacks."""
    codes = {code: re.findall(r"^\.B (\S+)", text, re.M)
             for code, text in re.findall(r"^\.B (\d+)\n((?:(?!\.B \d).*\n?)*)", section("EXIT STATUS"), re.M)}
    for command in subcommands():
        if f".B proskill {command}\n" not in section("SYNOPSIS"):
            yield f"man/proskill.1: SYNOPSIS lacks `proskill {command}`"
        for code in re.findall(r"^  (\d) ", help_of(command).partition("Exit code:\n")[2], re.M):
            if command not in codes.get(code, []):
                yield f"man/proskill.1: EXIT STATUS {code} lacks `{command}`"


def warnings():
    """Warnings of man about the manual page."""
    done = subprocess.run(["man", "--warnings", "-l", "-Tutf8", "man/proskill.1"], cwd=ROOT,
                          capture_output=True, text=True, env={"LC_ALL": "C.UTF-8", "MANWIDTH": "80",
                                                               "PATH": "/usr/bin:/bin"})
    return done.stderr.splitlines()


found = [complaint for command in subcommands() for complaint in complaints(command)]
found += [*missing_in_manual(), *made(), *warnings()]
if not subcommands():
    found.append("`proskill --help` shows no subcommands")
finish(found, f"--help, the manual page and three shells agree on {', '.join(subcommands())}")
