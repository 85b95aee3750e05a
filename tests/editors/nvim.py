"""Runs a test of the Neovim plugin in Neovim.

usage: nvim.py SCRIPT

PROSKILL_NVIM names another Neovim than the one on the PATH. The script runs in one Neovim, and drives
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

program = os.environ.get("PROSKILL_NVIM") or shutil.which("nvim")
if not program:
    print("skipped: nvim is not installed (apt-get install neovim)")
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
