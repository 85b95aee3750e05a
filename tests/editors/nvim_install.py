"""The Neovim plugin in the ways in which people install it: file types, commands and help are there in each.

usage: nvim_install.py

A link in Neovim's own packages, `runtimepath` as vim-plug and packer set it for a directory of a repository, and setup.lua for managers
that know a repository's root alone, such as lazy.nvim and mini.deps. PROSKILL_NVIM names another Neovim than the one on the PATH.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

PLUGIN = pathlib.Path(__file__).resolve().parents[2] / "editors/nvim"

program = os.environ.get("PROSKILL_NVIM") or shutil.which("nvim")
if not program:
    print("skipped: nvim is not installed (apt-get install neovim)")
    sys.exit(77)

# What users do next: open a program and a model, run a command, read the help.
LOOK = """
edit main.proskill
let filetypes = &filetype
edit model.fcr
let filetypes .= ' ' . &filetype
let command = exists(':ProskillVerify')
help proskill
let topic = expand('%:t')
help :ProskillTrace
call writefile([filetypes, string(command), topic, getline('.')], 'seen')
qall!
"""
WANTED = ["proskill fiacre", "2", "proskill.txt"]


def seen(name, configure):
    """What Neovim has with a configuration that `configure` writes, given the clone and the places of a user's files."""
    with tempfile.TemporaryDirectory() as directory:
        home = pathlib.Path(directory)
        clone = home / "clone"
        shutil.copytree(PLUGIN, clone / "editors/nvim", ignore=shutil.ignore_patterns("parser"))
        (home / "config/nvim").mkdir(parents=True)
        (home / "data/nvim").mkdir(parents=True)
        (home / "config/nvim/init.lua").write_text(configure(clone, home / "data/nvim"))
        (home / "look.vim").write_text(LOOK)
        environment = dict(os.environ, HOME=directory, LC_ALL="C.UTF-8", XDG_CONFIG_DIRS="/nowhere", XDG_DATA_DIRS="/nowhere")
        for kind in ("CONFIG", "DATA", "STATE", "CACHE"):
            environment[f"XDG_{kind}_HOME"] = f"{directory}/{kind.lower()}"
        done = subprocess.run([program, "--headless", "-i", "NONE", "-n", "-S", "look.vim"], cwd=home, env=environment, timeout=120,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        result = home / "seen"
        lines = result.read_text().splitlines() if result.exists() else []
        if lines[:3] != WANTED or "ProskillTrace" not in (lines + [""] * 4)[3]:
            return [f"{name}: {lines}", done.stderr]
        return []


def package(clone, data):
    place = data / "site/pack/proskill/start"
    place.mkdir(parents=True)
    (place / "proskill").symlink_to(clone / "editors/nvim")
    return ""


def path(clone, _):
    return f"vim.opt.runtimepath:append('{clone}/editors/nvim')\n"


def script(clone, _):
    return f"dofile('{clone}/editors/nvim/setup.lua')\n"


complaints = [line for name, configure in [("a package", package), ("runtimepath", path), ("setup.lua", script)]
              for line in seen(name, configure)]

# Managers generate the tags again; they must equal the existing ones, so that an installation does not change the clone.
with tempfile.TemporaryDirectory() as directory:
    shutil.copytree(PLUGIN / "doc", f"{directory}/doc", ignore=shutil.ignore_patterns("tags"))
    subprocess.run([program, "--headless", "-u", "NONE", "-i", "NONE", "-c", f"helptags {directory}/doc", "-c", "quit"], check=True,
                   stdin=subprocess.DEVNULL, capture_output=True)
    if pathlib.Path(f"{directory}/doc/tags").read_text() != (PLUGIN / "doc/tags").read_text():
        complaints.append("editors/nvim/doc/tags is not that of the help: nvim -u NONE -c 'helptags editors/nvim/doc' -c q")

print("\n".join(complaints) or "installed in three ways")
sys.exit(1 if complaints else 0)
