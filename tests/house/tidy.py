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

    tidy.BUILD = tidy.ROOT / "build"
    tidy.PARTS = tidy.BUILD / "parts"
    tidy.BUILD.mkdir()
    for name in ("header.h", "a.h"):
        pathlib.Path(tidy.ROOT, name).write_text("", encoding="utf-8")
    for name in ("a.cpp", "b.cpp", "header.cpp"):
        pathlib.Path(tidy.ROOT, name).write_text('#include "header.h"\n#include "a.h"\n', encoding="utf-8")
    (tidy.BUILD / "unity.cxx").write_text("".join(f'#include "{tidy.ROOT / name}"\n' for name in ("a.cpp", "b.cpp", "header.cpp")),
                                          encoding="utf-8")
    whole = tidy.Unit.of({"file": str(tidy.BUILD / "unity.cxx"), "command": f"c++ -c {tidy.BUILD / 'unity.cxx'}"})
    for names, sources in (({"b.cpp"}, {"b.cpp"}), ({"b.cpp", "header.h"}, {"b.cpp"}), ({"header.h"}, {"header.cpp"}), ({"a.h"}, {"a.cpp"})):
        expect(f"to read {sorted(names)}", [unit.sources for unit in tidy.covering([whole], names)], [sources])
    (tidy.BUILD / "bytes.cpp").write_text('#include "a.h"\n', encoding="utf-8")
    expect("what is generated", tidy.Unit.of({"file": str(tidy.BUILD / "bytes.cpp"), "command": ""}).sources, set())
    part = whole.part({"b.cpp"})
    expect("the part", pathlib.Path(part.file).read_text(encoding="utf-8"), f'#include "{tidy.ROOT / "b.cpp"}"\n')
    expect("its command", part.command, f"c++ -c {part.file}")
    expect("what is read whole", whole.part({"a.cpp", "b.cpp", "header.cpp"}), whole)
    (tidy.BUILD / "more.cxx").write_text(f'#include "{tidy.ROOT / "mine.cpp"}"\n', encoding="utf-8")
    more = tidy.Unit.of({"file": str(tidy.BUILD / "more.cxx"), "command": f"c++ -c {tidy.BUILD / 'more.cxx'}"})
    both = tidy.covering([whole, more], {"b.cpp", "mine.cpp"})
    expect("groups of a target", [unit.sources for unit in both], [{"b.cpp", "mine.cpp"}])
    expect("if they clash, the units of the build", both[0].wholes, [more, whole])
    tidy.MOST = 1
    expect("many files", [unit.sources for unit in tidy.covering([whole, more], {"b.cpp", "mine.cpp"})], [{"mine.cpp"}, {"b.cpp"}])
finish(found, "15 cases")
