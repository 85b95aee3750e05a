"""`./dev demo` gets by with the packages that `./dev` installs for it: what its configuration finds and what the program's
sources read belongs to these, to what they depend on, or to a Debian that has nothing but git.

usage: demo.py BUILD_DIRECTORY
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from house import ROOT, finish, read

BUILD = pathlib.Path(sys.argv[1]).resolve()
BARE = ["git", "ca-certificates", "apt"]
FORMAT = "${Package}\\t${Status}\\t${Essential}\\t${Priority}\\t${Pre-Depends}, ${Depends}\\t${Provides}\\n"


def run(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, **more)


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def to_build():
    return re.search(r"^toBuild=\((.*?)\)", read("dev"), re.M | re.S)[1].split()


def names(relation):
    """The packages of a field such as `libc6 (>= 2.36), gcc | clang`."""
    return re.findall(r"(?:^|[,|])\s*([a-z0-9][a-z0-9.+-]+)", relation)


class Packages:
    """Those of this system, and what each brings with it."""

    def __init__(self):
        self.depends, self.provided, self.minimal = {}, {}, set()
        for row in run("dpkg-query", "--show", f"--showformat={FORMAT}").stdout.splitlines():
            name, status, essential, priority, depends, provides = row.split("\t")
            if not status.endswith(" installed"):
                continue
            self.depends[name] = names(depends)
            for virtual in names(provides):
                self.provided.setdefault(virtual, []).append(name)
            if essential == "yes" or priority == "required":
                self.minimal.add(name)

    def closure(self, wanted):
        found, todo = set(), list(wanted)
        while todo:
            name = todo.pop()
            if name in found:
                continue
            found.add(name)
            todo += self.depends.get(name, []) + self.provided.get(name, [])
        return found & set(self.depends)


def owners(files):
    """The package of each file; files that no package has are not there."""
    real = {os.path.realpath(file) for file in files}
    both = sorted(real | {file.removeprefix("/usr") for file in real})  # what dpkg still knows below /bin and /lib
    found = {}
    for row in run("dpkg-query", "--search", *both).stdout.splitlines():
        packages, _, file = row.partition(": ")
        for package in packages.split(", "):
            found.setdefault(package.split(":")[0], file)
    return found


def configured(directory):
    """What CMake reads and finds on the system, from a configuration of its own: the cache's paths, and modules."""
    trace = directory / "trace"
    done = run("cmake", "--preset", "program", "-D", "PROSKILL_ROS2=OFF", "-D", "PROSKILL_MPI=OFF", "-B", directory / "build", "--trace",
               "--trace-format=json-v1", f"--trace-redirect={trace}", cwd=ROOT)
    if done.returncode:
        finish([done.stdout + done.stderr], "")
    cache = (directory / "build/CMakeCache.txt").read_text(encoding="utf-8")
    read_files = set(re.findall(r'"file":"(/usr/[^"]+)"', trace.read_text(encoding="utf-8")))
    return read_files | {path for path in re.findall(r"=(/usr/\S+)$", cache, re.M) if os.path.isfile(path)}


def compiled():
    """The headers that the program's sources read, as ninja has them from the compiler. What ROS 2 and MPI need is not the program's."""
    shown = run("ninja", "-C", BUILD, "-t", "deps").stdout
    own = re.compile(r"^(?!tests/|bench/|fuzz/|dds/|mpi/)\S+:.*\n((?:    .*\n)+)", re.M)
    return {line.strip() for part in own.findall(shown) for line in part.splitlines() if line.strip().startswith("/usr/")}


def missing(packages, wanted, used):
    allowed = packages.closure([*wanted, *BARE, *packages.minimal])
    return {package: file for package, file in used.items() if package not in allowed}


if not shutil.which("dpkg-query"):
    skip("this is no Debian, and which package a file is of is dpkg's to know")
packages = Packages()
with tempfile.TemporaryDirectory() as scratch:
    used = owners(configured(pathlib.Path(scratch)) | compiled())
complaints = [f"the program needs {package} ({file}), which toBuild in ./dev does not bring"
              for package, file in sorted(missing(packages, to_build(), used).items())]
complaints += [f"this check would not notice if toBuild lacked {package}" for package in to_build()
               if package in used and package.endswith("-dev")
               and package not in missing(packages, [other for other in to_build() if other != package], used)]
complaints += [f"./dev's toBuild has {package}, which nothing uses" for package in to_build()
               if package.endswith("-dev") and package not in used and not packages.closure([package]) & set(used)]
finish(complaints, f"{len(used)} packages are used, all of them of toBuild and what it brings")
