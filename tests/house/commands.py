"""Whatever `--help` shows, the manual page describes and the shells complete.

usage: commands.py PROGRAM
"""

import re
import shutil
import subprocess
import sys

from house import ROOT, finish, read

PROGRAM = sys.argv[1]
PAGES = ["man/proskill.1", "completions/proskill.bash", "completions/_proskill",
         "completions/proskill.fish"]


def help_of(*command):
    done = subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True, check=True)
    return done.stdout


def subcommands():
    """The words below `Subcommands:`."""
    _, _, below = help_of().partition("Subcommands:\n")
    return re.findall(r"^  (\S+)", below.split("\n\n")[0], re.M)


def options(command):
    return set(re.findall(r"^  (?:-\w,)?--([a-z-]+)", help_of(command), re.M))


def mentions(page):
    """What a page speaks of: commands as words, options as `--option`, however its language writes them."""
    text = read(page).replace("\\-", "-")
    text = re.sub(r" -l ([a-z-]+)", r" --\1", text)
    text = re.sub(r"^__proskill_option ('[^']*'|\S+) ", r"\1 --", text, flags=re.M)  # both of fish
    return set(re.findall(r"(?:--)?[a-z][a-z-]*", text))


def missing(page):
    known = mentions(page)
    for command in subcommands():
        for word in sorted(({"--" + option for option in options(command)} | {command}) - known):
            yield f"{page}: nothing on `{word}` of `proskill {command}`"


def warnings():
    """What man has to say about the manual page."""
    done = subprocess.run(["man", "--warnings", "-l", "-Tutf8", "man/proskill.1"], cwd=ROOT,
                          capture_output=True, text=True, env={"LC_ALL": "C.UTF-8", "MANWIDTH": "80",
                                                               "PATH": "/usr/bin:/bin"})
    return done.stderr.splitlines()


found = [complaint for page in PAGES for complaint in missing(page)]
has_man = shutil.which("man")
if has_man:
    found += warnings()
if not subcommands():
    found.append("`proskill --help` shows no subcommands")
if not found and not has_man:
    print("skipped: man is not installed (apt-get install man-db); that the manual page has no errors was not tried")
    sys.exit(77)
finish(found, f"{len(PAGES)} pages know {', '.join(subcommands())}")
