"""What clang-tidy reads in `./dev test`: what changed on the branch or in the last commits, or else all; and no file is in no unit."""

import pathlib
import subprocess
import sys
import tempfile

from house import ROOT, finish

sys.path.insert(0, str(ROOT / "scripts"))
import tidy  # noqa: E402

found = []


def expect(what, value, wanted):
    if value != wanted:
        found.append(f"{what}: {value} instead of {wanted}")


def git(*arguments):
    subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *arguments], cwd=tidy.ROOT, check=True, capture_output=True)


def commit(name, before=""):
    pathlib.Path(tidy.ROOT, name).write_text(before + f"// {name}\n" * 10, encoding="utf-8")
    git("add", name)
    git("commit", "-qm", name)


class Unit:
    def __init__(self, *files):
        self.files = set(files)


with tempfile.TemporaryDirectory() as directory:
    tidy.ROOT = pathlib.Path(directory)
    git("init", "-q", "-b", "main")
    for i in range(tidy.RECENT):
        commit(f"{i}.cpp")
    expect("with a short history", tidy.changed()[0], {f"{i}.cpp" for i in range(tidy.RECENT)})
    commit("last.cpp")
    expect("on main", tidy.changed()[0], {f"{i}.cpp" for i in range(1, tidy.RECENT)} | {"last.cpp"})
    git("checkout", "-qb", "branch")
    commit("mine.cpp")
    expect("on a branch", tidy.changed(), ({"mine.cpp"}, "since the branch left main"))
    git("mv", "last.cpp", "moved.cpp")
    commit("9.cpp", '#include "moved.h"\n')
    expect("where files only move", tidy.changed()[0], {"mine.cpp"})
    units = [Unit("mine.cpp", "moved.cpp"), *(Unit(f"{i}.cpp") for i in range(1, tidy.RECENT))]
    expect("without a unit", tidy.unread(units), {"0.cpp"})
finish(found, "5 cases")
