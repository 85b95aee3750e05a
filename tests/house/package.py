"""cpack makes a Debian package with all that belongs into it, and its program runs.

usage: package.py BUILD_DIRECTORY
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

from house import finish

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
    f"{NVIM}/ftplugin/proskill.lua", f"{NVIM}/doc/proskill.txt", f"{NVIM}/parser/proskill.so",
    f"{NVIM}/queries/proskill/highlights.scm",
    "usr/share/emacs/site-lisp/proskill-mode.el", "usr/share/proskill/helix/languages.toml",
    "usr/share/proskill/helix/queries/proskill/highlights.scm",
    f"{DOC}/copyright", f"{DOC}/README.md", f"{DOC}/CHANGELOG.md", f"{DOC}/docs/language.md",
    f"{DOC}/examples/drone/drone.proskill",
]
LIBRARIES = ["libtree-sitter", "libgvc", "libcgraph", "libfmt"]


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        finish([f"{' '.join(map(str, command))} failed", done.stdout + done.stderr], "")
    return done.stdout


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
    root = pathlib.Path(directory) / "root"
    run("dpkg-deb", "-x", package, root)
    run(root / "usr/bin/proskill", "check", root / DOC / "examples/drone/drone.proskill")
finish(complaints, f"{package.name}: {len(names)} entries")
