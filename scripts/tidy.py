"""Runs clang-tidy on the sources and headers of the program; warnings are errors.

usage: tidy.py PROGRAM changed|all
  changed: the files that differ from where the branch left main; on main, those of the last ten commits. A clone with less
           history has no such base, and all are read.

It reads the files in the groups of the unity builds, because headers take most of its time. `changed` reads only the files of
a group that changed, those of a target together. What is clean stays so until a file of it changes: build/tidy/clean/ remembers.
"""

import concurrent.futures
import functools
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
PARTS = BUILD / "parts"
MOST = 24  # files of several groups that are read together
RECENT = 10  # commits; about 20 of the 1500 files, and a minute of processor time
OTHERS = ("fuzz/coverage.cpp", "fuzz/entry.cpp", "tree-sitter-proskill/", "build/", "tests/cli/hippo/",
          "runtime/stubs/hippo/", "examples/embedded/")  # the first two need libFuzzer, others are C, or built against what is installed
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


@functools.cache
def included(name):
    """The tree's files that this one includes directly."""
    return INCLUDE.findall((ROOT / name).read_text(encoding="utf-8")) if (ROOT / name).is_file() else []


@functools.cache
def files_of(source):
    """The source, and the tree's headers that it includes."""
    files, todo = set(), [source]
    while todo:
        name = todo.pop()
        if name not in files and (ROOT / name).is_file():
            files.add(name)
            todo += included(name)
    return files


class Unit:
    """Input of one run of clang-tidy: some sources, and the tree's headers that they include."""

    def __init__(self, file, command, sources, wholes=()):
        """wholes: the units of the build of which this has some sources; none if it is one of them."""
        self.file, self.command, self.sources, self.wholes = file, command, sources, wholes
        self.files = set().union(*map(files_of, sources))

    @staticmethod
    def of(command):
        file = command["file"]
        text = pathlib.Path(file).read_text(encoding="utf-8")
        # groups name their sources by absolute paths; what else is in the build directory is generated
        found = [path for path in INCLUDE.findall(text) if os.path.isabs(path)] if file.startswith(str(BUILD)) else [file]
        return Unit(file, command["command"], {os.path.relpath(path, ROOT) for path in found})

    @property
    def target(self):
        """Equal for units of the same compiler options; a source that is compiled alone is read alone."""
        return os.path.dirname(self.file) if self.file.startswith(str(BUILD)) else self.file

    def part(self, sources):
        """The unit with some of its sources only."""
        return self if sources == self.sources else self.with_sources("part", sources, [self])

    def joined(self, others):
        """The unit together with others of its target."""
        all_of = [self, *others]
        return self.with_sources("joined", set().union(*(it.sources for it in all_of)),
                                 [whole for it in all_of for whole in it.wholes or [it]]) if others else self

    def with_sources(self, kind, sources, wholes):
        file = PARTS / kind / os.path.relpath(self.file, PARTS / "part" if self.file.startswith(str(PARTS)) else BUILD)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("".join(f'#include "{ROOT / name}"\n' for name in sorted(sources)), encoding="utf-8")
        return Unit(str(file), self.command.replace(self.file, str(file)), sources, wholes)

    def stamp(self, program):
        """Digest of everything that the result depends on, except the system's headers."""
        digest = hashlib.sha256(program.encode() + self.command.encode() + TESTS.encode())
        for name in [".clang-tidy", *sorted(self.files)]:
            digest.update(name.encode() + (ROOT / name).read_bytes())
        return CLEAN / digest.hexdigest()


def units():
    subprocess.run(["cmake", "--preset", "tidy"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    found = [Unit.of(command) for command in commands
             if not command["file"].endswith(".c") and pathlib.Path(command["file"]).is_file()]
    return [unit for unit in found if unit.sources and not any(name.startswith(OTHERS) for name in unit.sources)]


def unread(found):
    """The sources and headers in no unit."""
    tracked = set(git("ls-files", "*.cpp", "*.h").stdout.splitlines())
    return {name for name in tracked if not name.startswith(OTHERS)} - set().union(*(unit.files for unit in found))


def covering(found, names):
    """Units of these files: a source itself; a header with a source that includes it, best one of its name or folder."""
    read = {unit: unit.sources & names for unit in found}
    seen = set().union(*(files_of(source) for sources in read.values() for source in sources))
    for header in sorted(name for name in names if name.endswith(".h")):
        having = [(unit, source) for unit in found for source in unit.sources if header in files_of(source)]
        if header in seen or not having:
            continue
        unit, source = min(having, key=lambda it: distance(header, it[1]))
        read[unit] |= {source}
        seen |= files_of(source)
    groups = []
    for unit, sources in sorted(((unit, sources) for unit, sources in read.items() if sources), key=lambda it: it[0].file):
        last = groups[-1] if groups else []
        if not last or last[0][0].target != unit.target or len(sources) + sum(len(it) for _, it in last) > MOST:
            groups.append(last := [])
        last.append((unit, sources))
    return [first.joined(rest) for first, *rest in ([unit.part(sources) for unit, sources in group] for group in groups)]


def distance(header, source):
    """Orders the sources that include a header; the name makes the choice the same each time."""
    return (os.path.splitext(header)[0] != os.path.splitext(source)[0], os.path.dirname(header) != os.path.dirname(source), source)


def write_commands(chosen):
    """The compile commands of what is read, among which clang-tidy looks for them."""
    PARTS.mkdir(exist_ok=True)
    commands = [{"directory": str(BUILD), "command": unit.command, "file": unit.file} for some in chosen for unit in (some, *some.wholes)]
    (PARTS / "compile_commands.json").write_text(json.dumps(commands), encoding="utf-8")


def tidy(program, unit):
    """The warnings of a unit, each as one line."""
    found = warnings_of(program, unit)
    # files of different groups may use one name for two things, and a file may use an include of its group
    differs = unit.wholes and any("[clang-diagnostic-error" in line for line in found)
    return set().union(*(warnings_of(program, it) for it in unit.wholes)) if differs else found


def warnings_of(program, unit):
    lenient = [TESTS] if any(name.startswith("tests/") for name in unit.sources) else []
    for _ in range(2):  # again if it was killed, as by want of memory
        done = subprocess.run([program, "-p", PARTS, "--quiet", *lenient, unit.file], cwd=ROOT, capture_output=True, text=True)
        found = set(WARNING.findall(done.stdout))
        if found or not done.returncode:
            break
    else:
        found = {f"{unit.file}: clang-tidy ends with {done.returncode}\n{done.stdout}{done.stderr}"}
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
    write_commands(chosen)
    todo = [unit for unit in chosen if not unit.stamp(version).exists()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() + 1) as pool:
        for unit, said in zip(todo, pool.map(lambda unit: tidy(program, unit), todo)):
            print("".join(f"{line}\n" for line in sorted(said - warnings)), end="", flush=True)
            warnings |= said
            if not said:
                unit.stamp(version).touch()
    print(f"clang-tidy ({since}): {len(warnings)} warnings; {sum(len(unit.sources) for unit in chosen)} files in "
          f"{len(chosen)} of {len(found)} units, {len(todo)} of them read anew")
    return 1 if warnings else 0


if __name__ == "__main__":
    sys.exit(main())
