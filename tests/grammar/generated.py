"""The parser in the tree is the one that grammar.js gives.

usage: generated.py BUILD_DIRECTORY        which keeps the generator, for it takes half a minute to build
"""

import filecmp
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import npm  # noqa: E402

GRAMMAR = npm.ROOT / "tree-sitter-proskill"
BUILD = pathlib.Path(sys.argv[1]).resolve()


def cargo(*arguments):
    return subprocess.run(["cargo", *arguments, "--locked", "--manifest-path", HERE / "generate/Cargo.toml"],
                          env=dict(os.environ, CARGO_TARGET_DIR=str(BUILD)), capture_output=True, text=True)


def need_cargo():
    """One that can read the lock file."""
    if not shutil.which("cargo"):
        npm.skip("cargo is not installed (apt-get install cargo-web)")
    shown = subprocess.run(["cargo", "--version"], capture_output=True, text=True).stdout
    version = re.match(r"cargo 1\.(\d+)", shown)
    if not version or int(version[1]) < 88:
        npm.skip(f"this is {shown.strip()}, and 1.88 is needed (apt-get install cargo-web)")


def build_generator():
    """Only without the registry is the test skipped."""
    need_cargo()
    fetched = cargo("fetch")
    if fetched.returncode:
        npm.skip(f"cargo reaches no registry: {fetched.stderr.strip().splitlines()[-1].strip()}")
    built = cargo("build", "--offline")
    if built.returncode:
        print(built.stderr)
        sys.exit(1)
    return BUILD / "debug/generate"


def generate(copy):
    """Into a folder that has grammar.js and the scanner alone."""
    (copy / "src").mkdir()
    shutil.copy(GRAMMAR / "grammar.js", copy)
    ended = subprocess.run([generator, copy], capture_output=True, text=True)
    if ended.returncode:
        print(ended.stdout + ended.stderr)
        sys.exit(1)


def contents(folder):
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


if not shutil.which("node"):
    npm.skip("node is not installed (apt-get install npm), which runs grammar.js")
generator = build_generator()
with tempfile.TemporaryDirectory() as scratch:
    made = pathlib.Path(scratch) / "src"
    generate(made.parent)
    names = contents(made)
    complaints = [f"{name} is not what grammar.js gives: run `npm run generate` there"
                  for name in names if not filecmp.cmp(made / name, GRAMMAR / "src" / name, shallow=False)]
    complaints += [f"src/{name} is neither generated nor the scanner"
                   for name in contents(GRAMMAR / "src") - names - {pathlib.Path("scanner.c")}]
print("\n".join(complaints) or f"{len(names)} files are as generated")
sys.exit(1 if complaints or not names else 0)
