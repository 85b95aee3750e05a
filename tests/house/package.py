"""cpack makes a Debian package with all that belongs into it, its program runs, and the Containerfile installs it.

usage: package.py BUILD_DIRECTORY
"""

import fnmatch
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from house import ROOT, finish, read

BUILD = pathlib.Path(sys.argv[1])
DOC = "usr/share/doc/proskill"
GRAMMAR = "usr/share/proskill/tree-sitter-proskill"
NVIM = "usr/share/nvim/site/pack/proskill/start/proskill"
WANTED = [
    "usr/bin/proskill",
    "usr/share/man/man1/proskill.1",
    "usr/share/bash-completion/completions/proskill",
    "usr/share/zsh/vendor-completions/_proskill",
    "usr/share/fish/vendor_completions.d/proskill.fish",
    f"{GRAMMAR}/grammar.js", f"{GRAMMAR}/src/parser.c", f"{GRAMMAR}/src/tree_sitter/parser.h",
    f"{GRAMMAR}/queries/highlights.scm", f"{GRAMMAR}/tree-sitter.json",
    f"{NVIM}/ftplugin/proskill.lua", f"{NVIM}/doc/proskill.txt", f"{NVIM}/doc/tags", f"{NVIM}/parser/proskill.so",
    f"{NVIM}/queries/proskill/highlights.scm",
    "usr/share/emacs/site-lisp/proskill-mode.el", "usr/share/emacs/site-lisp/proskill-platform.el", "usr/share/emacs/site-lisp/proskill-verdicts.el", "usr/share/proskill/helix/languages.toml",
    "usr/share/proskill/helix/queries/proskill/highlights.scm",
    "usr/lib/python3/dist-packages/proskill/__init__.py", "usr/lib/python3/dist-packages/proskill/py.typed",
    "usr/include/proskill/executor.h", "usr/include/proskill/executor.hpp", "usr/include/proskill/platform.h",
    "usr/lib/libproskill.so.1", "usr/lib/libproskill.so", "usr/lib/proskill/libproskill_view.so", "usr/lib/cmake/ProSkill/ProSkillConfig.cmake", "usr/lib/pkgconfig/proskill.pc",
    f"{DOC}/copyright", f"{DOC}/README.md", f"{DOC}/CHANGELOG.md", f"{DOC}/docs/language.md",
    f"{DOC}/examples/drone/drone.proskill",
]
# What each program reports on a file of the package, if the program is installed.
CHECKS = [
    ("man", ["man", "--warnings", "--local-file"], "usr/share/man/man1/proskill.1"),
    ("bash", ["bash", "-n"], "usr/share/bash-completion/completions/proskill"),
    ("zsh", ["zsh", "-n"], "usr/share/zsh/vendor-completions/_proskill"),
    ("fish", ["fish", "--no-execute"], "usr/share/fish/vendor_completions.d/proskill.fish"),
]
LIBRARIES = ["libtree-sitter", "libgvc", "libcgraph", "libutf8proc", "libfmt"]


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        finish([f"{' '.join(map(str, command))} failed", done.stdout + done.stderr], "")
    return done.stdout


def wrong(root, command, file):
    """The complaints of a program about a file; a manual page has to name every command."""
    done = subprocess.run([*command, root / file], capture_output=True, text=True, env={**os.environ, "MANPAGER": "cat", "MANWIDTH": "200"})
    found = [f"{file}: {line}" for line in done.stderr.splitlines()]
    if done.returncode:
        found.append(f"{command[0]} ends with {done.returncode} on {file}")
    commands = subprocess.run([root / "usr/bin/proskill", "--help"], capture_output=True, text=True).stdout
    text = done.stdout if command[0] == "man" else (root / file).read_text()
    names = re.findall(r"^  ([a-z]+)  ", commands, re.M)
    if len(names) < 8:
        found.append("proskill --help lists no commands")
    return found + [f"{file}: does not name `{name}`" for name in names if not re.search(rf"\b{name}\b", text)]


# The Containerfile is compared with the package; an image would need a registry and a daemon.
def instructions():
    """Pairs of an instruction of the Containerfile and its arguments."""
    text = re.sub(r"\\\n\s*", " ", read("Containerfile"))
    return [line.split(maxsplit=1) for line in text.splitlines() if re.match(r"[A-Z]+ ", line)]


def is_sent(path):
    """Whether .dockerignore lets the builder see it: the last rule that matches decides."""
    sent = True
    for rule in filter(None, read(".dockerignore").split()):
        if fnmatch.fnmatch(path, rule.removeprefix("!")):
            sent = rule.startswith("!")
    return sent


def wrong_copies(package):
    """Sources of COPY that are neither in the tree nor the package, and a destination from which nothing is installed."""
    complaints = []
    commands = " ".join(arguments for name, arguments in instructions() if name == "RUN")
    for *sources, target in (arguments.split() for name, arguments in instructions() if name == "COPY"):
        for source in sources:
            found = [f"build/{package}"] if fnmatch.fnmatch(f"build/{package}", source) else [str(it.relative_to(ROOT)) for it in ROOT.glob(source)]
            complaints += [] if found else [f"Containerfile: there is no {source}; the package is build/{package}"]
            complaints += [f".dockerignore: leaves out {path}" for path in found if not is_sent(path)]
        installed = [word for word in commands.split() if fnmatch.fnmatch(target + package, word)]
        complaints += [] if installed else [f"Containerfile: {target + package} is not installed"]
    return complaints


def wrong_container(package, names):
    """What does not fit a package with this file name and these entries."""
    programs = [json.loads(arguments)[0] for name, arguments in instructions() if name == "ENTRYPOINT"]
    absent = [f"Containerfile: {it} is not in {package}" for it in programs if f"usr/bin/{it}" not in names]
    return wrong_copies(package) + absent + ([] if programs else ["Containerfile: it runs no program"])


for program, debian in [("dpkg-shlibdeps", "dpkg-dev"), ("file", "file")]:
    if not shutil.which(program):
        print(f"skipped: {debian} is not installed (apt-get install {debian})")
        sys.exit(77)

with tempfile.TemporaryDirectory() as directory:
    run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", directory)
    package = next(pathlib.Path(directory).glob("proskill_*.deb"))
    names = {line.split()[5].removeprefix("./") for line in run("dpkg-deb", "-c", package).splitlines()}
    complaints = [f"{package.name}: {name} is missing" for name in WANTED if name not in names]
    complaints += [f"{package.name}: {name} is nothing for a user" for name in names
                   if "node_modules" in name or "/build/" in name or name.endswith(".o")]
    depends = run("dpkg-deb", "-f", package, "Depends")
    complaints += [f"{package.name}: does not depend on {library}" for library in LIBRARIES
                   if library not in depends]
    complaints += wrong_container(package.name, names)
    root = pathlib.Path(directory) / "root"
    run("dpkg-deb", "-x", package, root)
    run(root / "usr/bin/proskill", "check", root / DOC / "examples/drone/drone.proskill")
    complaints += [line for name, command, file in CHECKS if shutil.which(name) for line in wrong(root, command, file)]
finish(complaints, f"{package.name}: {len(names)} entries")
