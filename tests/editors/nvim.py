"""Runs a test of the Neovim plugin in Neovim.

usage: nvim.py SCRIPT [--newer]

PROSKILL_NVIM names another Neovim than the one on the PATH; --newer: the one that scripts/neovim.sh has unpacked. The script runs in one Neovim, and drives
a second one as a user would, by its keys: see nvim/child.lua. Neither sees the user's own configuration.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

newer = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "proskill/neovim-trixie/nvim"


def found():
    """The Neovim to test, and how to get it if it is missing."""
    if "--newer" in sys.argv:
        return shutil.which(newer), "the newer Neovim is not unpacked (scripts/neovim.sh)"
    return os.environ.get("PROSKILL_NVIM") or shutil.which("nvim"), "nvim is not installed (apt-get install neovim)"


program, missing = found()
if not program:
    print(f"skipped: {missing}")
    sys.exit(77)

with tempfile.TemporaryDirectory() as directory:
    environment = dict(os.environ, HOME=directory, PROSKILL_ROOT=str(ROOT), PROSKILL_SCRATCH=directory,
                       LC_ALL="C.UTF-8")
    for kind in ("CONFIG", "DATA", "STATE", "CACHE"):
        environment[f"XDG_{kind}_HOME"] = f"{directory}/{kind.lower()}"
    for name in ("NVIM", "NVIM_APPNAME", "MYVIMRC"):
        environment.pop(name, None)
    done = subprocess.run([program, "--headless", "-u", "NONE", "-i", "NONE", "-n",
                           "-c", f"luafile {HERE}/nvim/run.lua", "-c", "cquit 3"],
                          env=environment | {"PROSKILL_SCRIPT": sys.argv[1], "PROSKILL_NVIM": program},
                          stdin=subprocess.DEVNULL, timeout=280)
sys.exit(done.returncode)
