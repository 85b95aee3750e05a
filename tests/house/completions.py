"""The completions of the shells offer what the program takes, in each shell itself; one that is not installed is skipped by its name.

usage: completions.py PROGRAM bash|zsh|fish
"""

import os
import pathlib
import pty
import shutil
import signal
import subprocess
import sys
import tempfile

from house import ROOT, finish

PROGRAM, SHELL = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
FILES = ["main.proskill", "model.fcr", "notes.txt"]

# A command line, and some of the words to offer after it; a `!` marks words that must not be offered.
CASES = [
    ("proskill ", ["check", "verify", "view", "!--format"]),
    ("proskill ver", ["verify", "!check"]),
    ("proskill check --fo", ["--format", "!--fix"]),
    ("proskill check --format ", ["text", "short", "json", "sarif", "!junit"]),
    ("proskill verify --format j", ["json", "junit", "!text"]),
    ("proskill verify --reduce ", ["stubborn-sets", "free-inputs"]),
    ("proskill emit ", ["fiacre", "hfiacre"]),
    ("proskill check m", ["main.proskill", "model.fcr", "!notes.txt"]),
    ("proskill check n", ["!notes.txt"] if SHELL == "bash" else []),  # the others offer any file if none fits
    ("proskill verify main.proskill --property ", ["v.no_forbidden_transition", "s.can_run"]),
]

BASH = """
source "$1"; COMP_LINE=$2; COMP_POINT=${#2}
read -ra COMP_WORDS <<<"$2"; [[ $2 == *' ' ]] && COMP_WORDS+=('')
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
compopt() { :; }
_proskill; printf '%s\\n' "${COMPREPLY[@]}"
"""

# zsh completes only in a terminal, so it gets one; the offered words go to a file
ZSHRC = """
PS1=READY; LISTMAX=0; fpath=({completions} $fpath)
autoload -Uz compinit; compinit -u -D; compdef _proskill proskill
compadd() {{
  local -a found
  if [[ "$*" != *-[OAD]\ * ]]; then builtin compadd -O found "$@"; print -rl -- $found >>{offers}; fi
  builtin compadd "$@"
}}
finished() {{ print FINISHED >/dev/tty }}
zle -N finished; bindkey '^I' complete-word; bindkey '^X' finished
"""


def read_until(terminal, word):
    text = b""
    while word not in text:
        text += os.read(terminal, 4096)


def offered_by_zsh(line, directory, environment):
    offers = pathlib.Path(directory, ".offers")
    offers.write_text("", encoding="utf-8")
    pathlib.Path(directory, ".zshrc").write_text(
        ZSHRC.format(completions=ROOT / "completions", offers=offers), encoding="utf-8")
    process, terminal = pty.fork()
    if process == 0:
        os.chdir(directory)
        os.execvpe("zsh", ["zsh", "-d", "-i"], dict(environment, ZDOTDIR=directory))
    read_until(terminal, b"READY")
    os.write(terminal, line.encode() + b"\t\x18")
    read_until(terminal, b"FINISHED")
    os.kill(process, signal.SIGKILL)
    os.waitpid(process, 0)
    os.close(terminal)
    return {word.rstrip() for word in offers.read_text(encoding="utf-8").splitlines()} - {""}


def offered(line, directory):
    """The words that the shell offers after a line."""
    path = os.pathsep.join([str(PROGRAM.parent), os.environ["PATH"]])
    scripts = {"bash": ["bash", "--norc", "-c", BASH, "bash", str(ROOT / "completions/proskill.bash"), line],
               "fish": ["fish", "--no-config", "-c", "source $argv[1]; complete -C $argv[2]",
                        str(ROOT / "completions/proskill.fish"), line]}
    environment = dict(os.environ, PATH=path, HOME=directory, TERM="dumb")
    if SHELL == "zsh":
        return offered_by_zsh(line, directory, environment)
    done = subprocess.run(scripts[SHELL], cwd=directory, capture_output=True, text=True, timeout=60, env=environment)
    return {row.split("\t")[0].strip() for row in done.stdout.splitlines()} - {""}


if not shutil.which(SHELL):
    print(f"skipped: {SHELL} is not installed (apt-get install {SHELL})")
    sys.exit(77)
found = []
with tempfile.TemporaryDirectory() as directory:
    for name in FILES:
        pathlib.Path(directory, name).write_text("", encoding="utf-8")
    pathlib.Path(directory, "main.proskill").write_text(
        "(defsv v :states (A B) :init A :transitions :all)\n"
        "(defskill s :start (v A) :action (a) :success ok)\n(defskill m :success ok :body ((s) (success ok)))\n",
        encoding="utf-8")
    for line, words in CASES:
        there = offered(line, directory)
        found += [f"`{line}`: {word.strip('!')} is {'offered' if word[0] == '!' else 'not offered'} among {sorted(there)[:20]}"
                  for word in words if (word.strip("!") in there) == (word[0] == "!")]
finish(found, f"{len(CASES)} lines in {SHELL}")
