"""What the checks of the house share: the tree's root, its files, and the report."""

import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
GENERATED = ("tree-sitter-proskill/src/parser.c", "tree-sitter-proskill/src/tree_sitter/")


def tracked():
    """Files tracked by git or not ignored; none without git."""
    if not shutil.which("git"):
        return []
    return subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"],
                          cwd=ROOT, capture_output=True, text=True).stdout.splitlines()


def unpacked():
    """The files of an archive: all but those that the build and editors make."""
    names = (str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.is_file())
    return [name for name in names if not name.startswith(("build/", ".git/", ".cache/"))]


def files(*suffixes):
    """The tree's own files with these suffixes, as sorted paths relative to its root."""
    return sorted(name for name in set(tracked() or unpacked())
                  if name.endswith(suffixes) and not name.startswith(GENERATED)
                  and (ROOT / name).is_file())


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def finish(complaints, praise):
    """Ends the check: prints the complaints, and fails if there are any."""
    for complaint in complaints:
        print(complaint)
    if complaints:
        sys.exit(1)
    print(praise)
