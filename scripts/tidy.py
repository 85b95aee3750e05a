"""Runs clang-tidy on the sources and headers of the program; warnings are errors.

usage: tidy.py PROGRAM changed|all
  changed: the files that differ from where the branch left main; on main, those of the last ten commits. A clone with less
           history has no such base, and all are read.

It reads the files eight at a time, as the unity builds compile them, for to read headers is most of its time. What is
clean stays so until a file of it changes: build/tidy/clean/ remembers.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = ROOT / "build/tidy"
CLEAN = BUILD / "clean"
RECENT = 10  # commits; about 15 of the 80 units, and a minute of processor time
OTHERS = ("fuzz/coverage.cpp", "fuzz/entry.cpp", "tree-sitter-proskill/", "build/")  # the first two need libFuzzer
# in tests, `found == std::vector<Item>{}` prints the contents on failure, and string building need not be fast
TESTS = "--checks=-readability-container-size-empty,-performance-inefficient-string-concatenation"
INCLUDE = re.compile(r'^\s*#\s*include "([^"]+)"', re.M)
WARNING = re.compile(r"^\S+:\d+:\d+: (?:warning|error): .*$", re.M)


def git(*arguments):
    return subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True)


def base_of_changes():
    """The commit since which files count as changed, with a description; none if the history is too short."""
    head = git("rev-parse", "HEAD").stdout
    for main in ("origin/main", "main"):
        left = git("merge-base", "HEAD", main).stdout
        if left and left != head:
            return left.strip(), f"since the branch left {main}"
    ago = git("rev-parse", "--verify", "--quiet", f"HEAD~{RECENT}").stdout.strip()
    return (ago, f"in the last {RECENT} commits") if ago else (None, f"all: there are no {RECENT} commits here")


def changed():
    """The files that changed, and since when."""
    base, since = base_of_changes()
    return (changed_since(base) if base else set(git("ls-files").stdout.splitlines())), since


def changed_since(base):
    """A file that was only moved, or includes one that was, does not count."""
    fields = iter(git("diff", "-z", "--find-renames", "--ignore-matching-lines=^#include ", "--numstat",
                      base).stdout.split("\0"))
    names = set()
    for field in fields:
        if field:
            added, removed, name = field.split("\t")
            name = name or (next(fields), next(fields))[1]
            names |= {name} if (added, removed) != ("0", "0") else set()
    return names


class Unit:
    """Input of one run of clang-tidy: some sources, and the tree's headers that they include."""

    def __init__(self, command):
        self.file, self.command = command["file"], command["command"]
        text = pathlib.Path(self.file).read_text(encoding="utf-8")
        inside = self.file.startswith(str(BUILD))
        found = INCLUDE.findall(text) if inside else [self.file]
        self.sources = {os.path.relpath(path, ROOT) for path in found}
        self.files = set()
        todo = list(self.sources)
        while todo:
            name = todo.pop()
            if name in self.files or not (ROOT / name).is_file():
                continue
            self.files.add(name)
            todo += INCLUDE.findall((ROOT / name).read_text(encoding="utf-8"))

    def stamp(self, program):
        """Digest of everything that the result depends on, except the system's headers."""
        digest = hashlib.sha256(program.encode() + self.command.encode() + TESTS.encode())
        for name in [".clang-tidy", *sorted(self.files)]:
            digest.update(name.encode() + (ROOT / name).read_bytes())
        return CLEAN / digest.hexdigest()


def units():
    subprocess.run(["cmake", "--preset", "tidy"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    found = [Unit(command) for command in commands
             if not command["file"].endswith((".c", ".cxx_pch")) and pathlib.Path(command["file"]).is_file()]
    return [unit for unit in found if unit.sources and not any(name.startswith(OTHERS) for name in unit.sources)]


def unread(found):
    """The sources and headers in no unit."""
    tracked = set(git("ls-files", "*.cpp", "*.h").stdout.splitlines())
    return {name for name in tracked if not name.startswith(OTHERS)} - set().union(*(unit.files for unit in found))


def covering(found, names):
    """Units that contain these files: for a source its own; for a header one with its name or folder."""
    chosen = {unit.file: unit for unit in found if unit.sources & names}
    for name in sorted(names):
        if name.endswith(".h") and not any(name in unit.files for unit in chosen.values()):
            having = [unit for unit in found if name in unit.files]
            having.sort(key=lambda unit: not any(os.path.dirname(it) == os.path.dirname(name) for it in unit.sources))
            chosen.update((unit.file, unit) for unit in having[:1])
    return list(chosen.values())


def tidy(program, unit):
    """The warnings of a unit, each as one line."""
    lenient = [TESTS] if any(name.startswith("tests/") for name in unit.sources) else []
    done = subprocess.run([program, "-p", BUILD, "--quiet", *lenient, unit.file], cwd=ROOT, capture_output=True, text=True)
    found = set(WARNING.findall(done.stdout))
    if done.returncode and not found:
        found.add(done.stdout + done.stderr)
    return {line.replace(f"{ROOT}/", "") for line in found}


def main():
    program, which = sys.argv[1:]
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    found = units()
    names, since = changed() if which == "changed" else (set(), "all")
    chosen = covering(found, names) if which == "changed" else found
    warnings = {f"{name}: error: no unit has it, so nobody reads it" for name in unread(found)}
    print("".join(f"{line}\n" for line in sorted(warnings)), end="")
    CLEAN.mkdir(exist_ok=True)
    todo = [unit for unit in chosen if not unit.stamp(version).exists()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() + 1) as pool:
        for unit, said in zip(todo, pool.map(lambda unit: tidy(program, unit), todo)):
            print("".join(f"{line}\n" for line in sorted(said - warnings)), end="", flush=True)
            warnings |= said
            if not said:
                unit.stamp(version).touch()
    print(f"clang-tidy ({since}): {len(warnings)} warnings; {len(chosen)} of {len(found)} units, "
          f"{len(todo)} of them read anew")
    return 1 if warnings else 0


if __name__ == "__main__":
    sys.exit(main())
